#ifdef AS_CONSTANT
#define QUALIFIER constexpr
#define SHOW(x) show(x)
#else
#define QUALIFIER
#define SHOW(x) printf("%f", x)
#endif
extern "C" int printf(char const *, ...);
inline void show(double) {}
QUALIFIER static double gravity = 9.81;
inline void report(double x) { SHOW(x); }
struct Body {
  double mass;
#ifdef AS_CONSTANT
  double spin;
#endif
};
#ifndef AS_CONSTANT
inline double only_in_one(double x) { return x; } // no contradiction
#endif
