#ifndef BODY_H
#define BODY_H
#ifdef WITH_SPIN
double spin_of(double rate);
#endif
static inline double weight(double mass) { return mass * 9.81; }
#endif
