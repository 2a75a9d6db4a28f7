#include "program/bounded_compilation.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace symreal::program {

namespace {

constexpr double first_limit = 10; // seconds: within them the original of a source that is not large is not measured

// Without optimisation the compiler takes for a large source about seven times what the original does, and measuring
// that is once more: two of ten times are left. A process may go on for up to a second beyond its limit.
double limit_of_large(Outcome const &original) {
  constexpr double times = 2, least = 0.5;
  return std::max(least, times * original.processor_seconds - 1);
}

constexpr double most_times = 10, most_seconds_more = 1;
constexpr std::size_t most_memory_times = 5, most_memory_more = 300'000'000;
constexpr double megabyte = 1e6;

double most_seconds(Outcome const &original) { return most_times * original.processor_seconds + most_seconds_more; }

std::size_t most_memory(Outcome const &original) { return most_memory_times * original.most_memory + most_memory_more; }

// The sum of all tries.
struct Spent {
  double seconds = 0;
  std::size_t memory = 0;

  void add(Outcome const &outcome) {
    seconds += outcome.processor_seconds;
    memory = std::max(memory, outcome.most_memory);
  }
};

std::string told(std::string const &source, double seconds, Outcome const &original) {
  return fmt::format("{} is compiled without optimisation in symbolic mode: with it the compiler takes more than "
                     "{:.3g} s, where the original at -O1 takes {:.1f} s",
                     source, seconds, original.processor_seconds);
}

std::string told_beyond(std::string const &source, Outcome const &symbolic, Spent const &spent,
                        Outcome const &original) {
  return fmt::format("{}: without optimisation, too, the compiler takes {:.0f} s and {:.0f} MB in symbolic mode, and "
                     "all that was tried {:.0f} s, where the original at -O1 takes {:.1f} s and {:.0f} MB; --via-ir "
                     "records the instructions of the original instead",
                     source, symbolic.processor_seconds, static_cast<double>(spent.memory) / megabyte, spent.seconds,
                     original.processor_seconds, static_cast<double>(original.most_memory) / megabyte);
}

} // namespace

Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run) {
  if (std::optional<std::string> const before = run.kept ? run.kept->find(run.key) : std::nullopt) {
    run.tell(*before);
    return run.compile(compilation.unoptimised);
  }
  Spent spent;
  Command usual = compilation.usual;
  Outcome original{};
  auto const try_usual = [&](double limit) {
    usual.processor_limit = limit;
    Captured result = run.compile(usual);
    spent.add(result.outcome);
    return has_reached_limit(usual, result.outcome) ? std::nullopt : std::optional(std::move(result));
  };
  auto const measure = [&] {
    original = run.measure(compilation.original).outcome;
    spent.add(original);
    return original.success();
  };
  if (compilation.is_large && !measure()) return run.compile(compilation.usual); // it does not compile by itself
  double const first = compilation.is_large ? limit_of_large(original) : first_limit;
  if (std::optional<Captured> done = try_usual(first)) return *std::move(done);
  if (!compilation.is_large) {
    if (!measure()) return run.compile(compilation.usual);
    double const rest = most_seconds(original) - spent.seconds;
    if (rest > first_limit)
      if (std::optional<Captured> done = try_usual(rest)) return *std::move(done);
  }
  Captured result = run.compile(compilation.unoptimised);
  if (!result.outcome.success()) return result;
  std::string const text = told(compilation.source, usual.processor_limit, original);
  run.tell(text);
  spent.add(result.outcome);
  if (run.kept) run.kept->keep(run.key, text);
  if (spent.seconds > most_seconds(original) || spent.memory > most_memory(original))
    run.tell(told_beyond(compilation.source, result.outcome, spent, original));
  return result;
}

} // namespace symreal::program
