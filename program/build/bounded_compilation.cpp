#include "program/build/bounded_compilation.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace symreal::program {

namespace {

constexpr double most_times = 10, most_seconds_more = 1;
constexpr std::size_t most_memory_times = 5, most_memory_more = 300'000'000;
constexpr double megabyte = 1e6;

// Seconds before the original is measured; the runtime's header alone takes one. The compiler reads the original no
// faster than the rewriter did, so three times the reading time is within the bound.
double unmeasured(BoundedCompilation const &compilation) {
  constexpr double large = 1, other = 2, times_of_reading = 3;
  return std::max(compilation.is_large ? large : other, times_of_reading * compilation.reading);
}

double most_seconds(Outcome const &original) { return most_times * original.processor_seconds + most_seconds_more; }

// Limit of the optimised compilation. Unoptimised, a large source takes about seven times the original, and measuring
// takes one more: two of ten remain. A small source, where both take seconds, gets what the bound has left.
double limit_of_usual(BoundedCompilation const &compilation, Outcome const &original) {
  constexpr double times = 2, most_of_small = 5;
  double const left = most_seconds(original) - original.processor_seconds;
  return std::max(times * original.processor_seconds,
                  compilation.is_large ? unmeasured(compilation) : std::min(left, most_of_small));
}

std::size_t most_memory(Outcome const &original) { return most_memory_times * original.most_memory + most_memory_more; }

std::string told(std::string const &source, double seconds, Outcome const &original) {
  return fmt::format("{} is compiled without optimisation in symbolic mode: with it the compiler takes more than "
                     "{:.3g} s, where the original at -O1 takes {:.1f} s",
                     source, seconds, original.processor_seconds);
}

std::string told_beyond(std::string const &source, Outcome const &symbolic, double seconds, std::size_t memory,
                        Outcome const &original) {
  return fmt::format(
      "{}: without optimisation, too, the compiler takes {:.0f} s and {:.0f} MB in symbolic mode, and "
      "all that was tried {:.0f} s, where the original at -O1 takes {:.1f} s and {:.0f} MB; --record=instructions "
      "records the instructions of the original instead",
      source, symbolic.processor_seconds, static_cast<double>(memory) / megabyte, seconds, original.processor_seconds,
      static_cast<double>(original.most_memory) / megabyte);
}

} // namespace

Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run) {
  if (std::optional<std::string> const before = run.kept ? run.kept->find(run.key) : std::nullopt) {
    run.tell(*before);
    return run.compile(compilation.unoptimised);
  }
  Outcome original{};
  double limit = unmeasured(compilation);
  Command usual = compilation.usual;
  usual.processor_limit = {limit, [&] {
                             original = run.measure(compilation.original).outcome;
                             limit = original.success() ? limit_of_usual(compilation, original)
                                                        : std::numeric_limits<double>::infinity(); // does not compile
                             return limit;
                           }};
  Captured const tried = run.compile(usual);
  if (tried.outcome.ending != Ending::over_limit) return tried;
  Captured result = run.compile(compilation.unoptimised);
  if (!result.outcome.success()) return result;
  std::string const text = told(compilation.source, limit, original);
  run.tell(text);
  if (run.kept) run.kept->keep(run.key, text);
  double const seconds =
      tried.outcome.processor_seconds + original.processor_seconds + result.outcome.processor_seconds;
  std::size_t const memory = std::max({tried.outcome.most_memory, original.most_memory, result.outcome.most_memory});
  if (seconds > most_seconds(original) || memory > most_memory(original))
    run.tell(told_beyond(compilation.source, result.outcome, seconds, memory, original));
  return result;
}

} // namespace symreal::program
