inline double gravity(double v) { return 9.81 + 0 * v; }
