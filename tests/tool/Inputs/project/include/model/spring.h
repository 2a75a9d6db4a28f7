#pragma once
double spring(double stiffness, double length);
inline double twice(double x) { return x + x; }
