#ifndef TABLE_H
#define TABLE_H
#ifdef __cplusplus
extern "C" {
#endif
typedef struct joint {
  double angle, rate;
} joint;
double gravity(double mass, double angle);
joint *joints(int count);
#ifdef __cplusplus
}
#endif
#endif
