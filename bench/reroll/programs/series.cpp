// A series of N terms, as almanacs have them: amplitudes, frequencies and phases are numbers of the program.
#include <cmath>
#include <cstdlib>
#include <vector>

struct Term {
  double amplitude, frequency, phase;
};

#pragma symreal function input(t) constant(terms) output(return)
double series(std::vector<Term> const &terms, double t) {
  double sum = 0;
  for (Term const &term : terms) sum += (term.amplitude + term.phase * t) * std::sin(term.frequency * t + term.phase);
  return sum;
}

std::vector<Term> example_terms(int count) {
  std::vector<Term> terms;
  for (int k = 0; k < count; k++) terms.push_back({(k % 3 ? 0.75 : -1.25) / (k + 3), 0.25 * k + 0.125, 0.5 / (k + 2)});
  return terms;
}

#ifndef NO_MAIN
int main(int, char **argv) { return series(example_terms(std::atoi(argv[1])), 0.5) > 100; }
#endif
