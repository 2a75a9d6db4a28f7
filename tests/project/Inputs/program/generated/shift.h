#define SHIFT 0.25
