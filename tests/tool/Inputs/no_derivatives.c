#pragma symreal function input(x) output(return)
double k(double x) { return x * x; }

int main(void) { return k(2.0) == 4.0 ? 0 : 1; }
