double contact_force(double x) { return x * x; }
