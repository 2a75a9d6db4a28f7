// Check of code whose threads share an evaluation, against one thread: bitwise equality and speed.
#include "verify/check.h"

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

class Threads final : public Check {
public:
  // Compiles the file again without OpenMP.
  Threads(Subject &subject, Verification &result)
      : subject_(subject),
        alone_(subject.path, subject.banner, subject.graph, CodeBuild{.object = "generated-alone.so", .alone = true},
               *subject.front.build.cache, *subject.front.workspace),
        result_(result.threads.emplace(ThreadResult{subject.banner.threads})) {
    if (alone_.needs_program()) program_ = subject.start("the original", subject.original_program, &alone_);
  }

  void see(Sample const &sample, GeneratedCode::Result const &together) override {
    std::vector<double> const inputs = subject_.with_seeds(sample.inputs);
    GeneratedCode::Result const alone =
        program_ ? program_->run_generated({inputs, sample.parameters}, inputs) : alone_.run(inputs, sample.parameters);
    result_.different += alone.failed != together.failed || !all_same(alone.outputs, together.outputs);
  }

  bool compare(CheckedSample const &on) override {
    if (!timed_) timed_ = {subject_.with_seeds(on.sample.inputs), on.sample.parameters};
    return false;
  }

  void finish() override {
    if (timed_ && !alone_.needs_program()) result_.times = times_of(alone_, subject_.code, *timed_);
  }

private:
  Subject &subject_;
  GeneratedCode alone_;
  std::unique_ptr<Replay> program_; // if the code calls functions of the program
  std::optional<Sample> timed_;     // the first sample within the premises and all guards
  ThreadResult &result_;
};

} // namespace

std::unique_ptr<Check> check_threads(Subject &subject, Verification &result) {
  return subject.banner.threads > 1 ? std::make_unique<Threads>(subject, result) : nullptr;
}

} // namespace symreal::program
