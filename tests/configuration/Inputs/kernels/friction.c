double friction(double rate) { return 0.1 * rate; }
