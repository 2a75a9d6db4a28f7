#include "program/bounded_compilation.h"

#include <fmt/format.h>

namespace symreal::program {

namespace {

constexpr double first_limit = 10; // seconds: within them the original is not worth measuring
constexpr double most_times = 10, most_seconds_more = 1;
constexpr std::size_t most_memory_times = 5, most_memory_more = 300'000'000;
constexpr double megabyte = 1e6;

double most_seconds(Outcome const &original) { return most_times * original.processor_seconds + most_seconds_more; }

std::size_t most_memory(Outcome const &original) { return most_memory_times * original.most_memory + most_memory_more; }

std::string told(std::string const &source, double seconds, Outcome const &original) {
  return fmt::format("{} is compiled without optimisation in symbolic mode: with it the compiler takes more than "
                     "{:.0f} s, where the original at -O1 takes {:.1f} s",
                     source, seconds, original.processor_seconds);
}

std::string told_beyond(std::string const &source, Outcome const &symbolic, Outcome const &original) {
  return fmt::format("{}: without optimisation, too, the compiler takes {:.0f} s and {:.0f} MB in symbolic mode, where "
                     "the original at -O1 takes {:.1f} s and {:.0f} MB; --via-ir records the instructions of the "
                     "original instead",
                     source, symbolic.processor_seconds, static_cast<double>(symbolic.most_memory) / megabyte,
                     original.processor_seconds, static_cast<double>(original.most_memory) / megabyte);
}

} // namespace

Captured compile_bounded(BoundedCompilation const &compilation, BoundedRun const &run) {
  if (std::optional<std::string> const before = run.kept ? run.kept->find(run.key) : std::nullopt) {
    run.tell(*before);
    return run.compile(compilation.unoptimised);
  }
  Command usual = compilation.usual;
  usual.processor_limit = first_limit;
  Captured result = run.compile(usual);
  if (!has_reached_limit(usual, result.outcome)) return result;
  Outcome const original = run.measure(compilation.original).outcome;
  if (!original.success()) return run.compile(compilation.usual); // it is no program by itself
  if (most_seconds(original) > 2 * first_limit) {
    usual.processor_limit = most_seconds(original);
    result = run.compile(usual);
    if (!has_reached_limit(usual, result.outcome)) return result;
  }
  std::string const text = told(compilation.source, usual.processor_limit, original);
  run.tell(text);
  result = run.compile(compilation.unoptimised);
  Outcome const &plain = result.outcome;
  if (!plain.success()) return result;
  if (run.kept) run.kept->keep(run.key, text);
  if (plain.processor_seconds > most_seconds(original) || plain.most_memory > most_memory(original))
    run.tell(told_beyond(compilation.source, plain, original));
  return result;
}

} // namespace symreal::program
