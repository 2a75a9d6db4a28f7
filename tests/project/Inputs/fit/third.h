static BASE third(double x) { return x / 3; }
