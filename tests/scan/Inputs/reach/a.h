double filtered(double x);
