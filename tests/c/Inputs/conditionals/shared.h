#ifndef SHARED_H
#define SHARED_H
#include <math.h>
#ifdef __cplusplus
#define FACTOR 100.0
extern "C" {
#else
#define FACTOR 2.0
#endif
double scaled(double x);
double from_cpp(double x);
#ifdef __cplusplus
}
template <class T> T doubled(T x) { return 2 * x; }
#endif
#define IS_CPP defined(__cplusplus)
#endif
