#pragma GCC system_header
extern "C" {
static inline int band(double x) { return x > 1 ? 3 : 5; }
static inline void show(double) {}
}
