#ifndef PUMP_H
#define PUMP_H
#ifdef __cplusplus
extern "C" {
#endif
struct pump {
  double volume, pressure;
};
extern double ambient;
/* The work of a stroke. */
double stroke(struct pump *pump, double const *valve, int n);
#ifdef __cplusplus
}
#endif
#endif
