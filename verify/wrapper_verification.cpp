#include "verify/wrapper_verification.h"

#include "program/wrapper/wrapper_variations.h"
#include "runtime/replay/compare.h"
#include "verify/replay.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace symreal::program {
namespace {

constexpr std::size_t most_variations = 40;

} // namespace

std::vector<LeftState> values_missed_by_wrapper(Front const &front, RunOptions const &run, Recorded const &recorded,
                                                Graph const &graph, GeneratedCode const &code,
                                                std::string const &executable, std::vector<Sample> const &samples,
                                                double tolerance) {
  using Results = std::vector<std::vector<double>>;
  std::vector<LeftState> missed;
  std::vector<Variation> const variations = wrapper_variations(recorded);
  // Outputs on all samples; nullopt if the program does not end on one.
  auto const results = [&](std::string const &wish) -> std::optional<Results> {
    Replay program("the original with its wrapper", executable, run, recorded.begun_as, graph, *front.workspace, &code,
                   {}, {"SYMREAL_VARY=" + wish});
    Results all;
    try {
      for (Sample const &sample : samples) all.push_back(program.run(sample));
    } catch (DiagnosticError const &) {
      return std::nullopt;
    }
    return all;
  };
  auto const count_different = [&](Results const &original, std::optional<Results> const &other) {
    std::size_t count = other ? 0 : samples.size();
    for (std::size_t i = 0; other && i < samples.size(); ++i)
      count += !std::ranges::equal(original[i], (*other)[i],
                                   [&](double a, double b) { return same(a, b, code.banner().mode, tolerance); });
    return count;
  };
  for (std::size_t k = 0; k < std::min(variations.size(), most_variations); ++k) {
    std::string const without = fmt::format("-{}", k + 1);
    std::optional<Results> const original = results(without);
    if (!original) continue;
    std::size_t const different = count_different(*original, results(std::to_string(k + 1)));
    // Reruns the original: memory beyond an extent may hold anything, so its outputs may vary.
    if (different != 0 && count_different(*original, results(without)) == 0)
      missed.push_back({variations[k].where, different});
  }
  return missed;
}

} // namespace symreal::program
