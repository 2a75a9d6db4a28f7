static double square(double x) { return x * x; }

double force(double x, double v, double stiffness) { return -stiffness * x - 0.1 * square(v); }
