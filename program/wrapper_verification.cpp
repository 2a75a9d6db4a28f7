#include "program/wrapper_verification.h"

#include "program/baked_values.h"
#include "program/replay.h"
#include "verify/compare.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {
namespace {

constexpr std::size_t most_variations = 32;

} // namespace

std::vector<LeftState> values_missed_by_wrapper(Front const &front, RunOptions const &run, Recorded const &recorded,
                                                Graph const &graph, GeneratedCode const &code,
                                                std::string const &executable, std::vector<Sample> const &samples,
                                                double tolerance) {
  std::vector<LeftState> missed;
  std::vector<Variation> const variations = baked_variations(recorded);
  auto const results = [&](std::string const &wish) {
    Replay program("the original with its wrapper", executable, run, recorded.begun_as, graph, *front.workspace, &code,
                   {}, {"SYMREAL_VARY=" + wish});
    std::vector<std::vector<double>> all;
    for (Sample const &sample : samples) all.push_back(program.run(sample));
    return all;
  };
  for (std::size_t k = 0; k < std::min(variations.size(), most_variations); ++k) {
    std::size_t different = 0;
    try {
      std::vector<std::vector<double>> const original = results(fmt::format("-{}", k + 1)),
                                             wrapped = results(std::to_string(k + 1));
      for (std::size_t i = 0; i < samples.size(); ++i)
        different += !std::ranges::equal(original[i], wrapped[i],
                                         [&](double a, double b) { return same(a, b, code.banner().mode, tolerance); });
    } catch (DiagnosticError const &) {
      continue;
    }
    if (different != 0) missed.push_back({variations[k].label, different});
  }
  return missed;
}

} // namespace symreal::program
