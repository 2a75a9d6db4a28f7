double half(double x);
double third(double x);
double sixth(double x);
