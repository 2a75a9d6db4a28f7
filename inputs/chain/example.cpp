#include "example.h"

#include <cstdio>
#include <cstdlib>

namespace chain {

Model example_model(int argc, char **argv) {
  int const count = argc > 1 ? std::atoi(argv[1]) : 6;
  std::string const source = __FILE__;
  std::string const beside = source.substr(0, source.rfind("example.cpp")) + "data/chain-model.csv";
  return Model(read_links(argc > 2 ? argv[2] : beside, count));
}

std::vector<double> sequence(int n, double first, double step) {
  std::vector<double> values(n);
  for (int i = 0; i < n; i++) values[i] = first + step * i;
  return values;
}

void print(std::vector<double> const &values) {
  for (std::size_t i = 0; i < values.size(); i++) std::printf("%.17g\n", values[i]);
}

} // namespace chain
