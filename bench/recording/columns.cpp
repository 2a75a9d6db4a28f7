// What the columns of a recording cost: the same operations recorded without them, with carried values, and with values
// and source places. Interleaved rounds; medians and quartiles of nanoseconds an operation, and the ratio to the first.
#include "runtime/trace/nodes/pool.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <vector>

using symreal::RealNumber;
using symreal::trace::Pool;

// Products and sums of 6x6 matrices over and over, and a function now and then: what rigid-body code does.
[[gnu::noinline]] static void workload(std::size_t products) {
  constexpr std::size_t n = 6;
  Pool &pool = Pool::current();
  RealNumber a[n][n], b[n][n], c[n][n];
  std::uint32_t slot = 0;
  for (auto *matrix : {&a, &b})
    for (auto &row : *matrix)
      for (RealNumber &element : row) {
        element = pool.leaf(symreal::Node::input(slot), 0.1 + 0.01 * slot);
        ++slot;
      }
  for (std::size_t product = 0; product < products; ++product) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        RealNumber sum = a[i][0] * b[0][j];
        for (std::size_t k = 1; k < n; ++k) sum += a[i][k] * b[k][j];
        c[i][j] = sum;
      }
    for (std::size_t i = 0; i < n; ++i) c[i][i] = sin(c[i][i]);
    std::memcpy(a, c, sizeof a);
  }
}

int main() {
  constexpr std::size_t products = 5000, rounds = 15;
  struct Variant {
    char const *name;
    Pool::Columns columns;
    std::vector<double> nanoseconds = {};
  } variants[] = {{"no columns", {.values = false, .places = false}},
                  {"values", {.values = true, .places = false}},
                  {"values and places", {.values = true, .places = true}}};
  for (std::size_t round = 0; round < rounds; ++round)
    for (Variant &variant : variants) {
      Pool::current().begin(variant.columns);
      auto const start = std::chrono::steady_clock::now();
      workload(products);
      std::chrono::duration<double, std::nano> const time = std::chrono::steady_clock::now() - start;
      variant.nanoseconds.push_back(time.count() / static_cast<double>(Pool::current().end().size()));
    }
  std::printf("%-20s%12s%12s%12s%10s\n", "columns", "quartile", "median", "quartile", "ratio");
  double base = 0;
  for (Variant &variant : variants) {
    std::sort(variant.nanoseconds.begin(), variant.nanoseconds.end());
    double const median = variant.nanoseconds[rounds / 2];
    if (base == 0) base = median;
    std::printf("%-20s%12.1f%12.1f%12.1f%10.2f\n", variant.name, variant.nanoseconds[rounds / 4], median,
                variant.nanoseconds[rounds * 3 / 4], median / base);
  }
}
