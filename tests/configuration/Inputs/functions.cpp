namespace n {
double f(double x) { return x; }
double f(double x, int) { return x; }
#pragma symreal function input(x) output(return)
double g(double x) { return x; }
double h(double *x) { return *x; }
} // namespace n
int main() {
  double x = n::f(1) + n::g(1);
  return n::h(&x) > 0;
}
