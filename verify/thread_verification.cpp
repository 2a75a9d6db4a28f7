#include "verify/thread_verification.h"

#include "runtime/replay/compare.h"

#include <algorithm>
#include <cmath>

namespace symreal::program {

namespace {

constexpr std::size_t turns = 51, least_turns = 5;
constexpr double turn = 2e6, most_time = 1e9; // nanoseconds: of one turn, of all turns
constexpr std::size_t most_calls = 100000;

double quantile(std::vector<double> const &ascending, double share) {
  return ascending[static_cast<std::size_t>(std::lround(share * static_cast<double>(ascending.size() - 1)))];
}

std::vector<double> sorted(std::vector<double> values) {
  std::ranges::sort(values);
  return values;
}

ThreadTimes times_of(GeneratedCode &alone, GeneratedCode &together, Sample const &sample) {
  auto const time = [&](GeneratedCode &code, std::size_t calls) {
    return code.nanoseconds(sample.inputs, sample.parameters, calls);
  };
  time(together, 1); // starts the threads
  // Threads that wait for each other take far longer on a busy machine.
  double const once = std::max({time(alone, 2), time(together, 2), 1.0});
  std::size_t const calls = std::clamp<std::size_t>(static_cast<std::size_t>(turn / once), 1, most_calls);
  std::vector<double> one, all, gain;
  for (double spent = 0; gain.size() < turns && (gain.size() < least_turns || spent < most_time);) {
    one.push_back(time(alone, calls));
    all.push_back(time(together, calls));
    gain.push_back(one.back() / all.back());
    spent += (one.back() + all.back()) * static_cast<double>(calls);
  }
  one = sorted(one);
  all = sorted(all);
  gain = sorted(gain);
  return {quantile(one, 0.5),   quantile(all, 0.5),   quantile(gain, 0.5),
          quantile(gain, 0.25), quantile(gain, 0.75), gain.size()};
}

} // namespace

void ThreadVerification::compare(Sample const &sample, GeneratedCode::Result const &together) {
  GeneratedCode::Result const alone =
      program_ ? program_->run_generated(sample, sample.inputs) : alone_.run(sample.inputs, sample.parameters);
  bool const is_same = alone.failed == together.failed &&
                       std::ranges::equal(alone.outputs, together.outputs, [](double one, double other) {
                         return same(one, other, FloatingPoint::strict, 0);
                       });
  result_.different += !is_same;
}

ThreadResult ThreadVerification::finish(GeneratedCode &together, Sample const *sample) {
  if (sample && !alone_.needs_program()) result_.times = times_of(alone_, together, *sample);
  return result_;
}

} // namespace symreal::program
