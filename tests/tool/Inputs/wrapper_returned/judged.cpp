struct Judged {
  double value;
  int status;
};

#pragma symreal function input(x) output(return)
Judged judged(double x) {
  Judged result;
  result.value = 2 * x;
  result.status = 1;
  return result;
}

int main() { judged(1.5); }
