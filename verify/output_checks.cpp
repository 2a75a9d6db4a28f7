// Checks of the outputs of a call: generated code, recorded graph and other builds against the original.
#include "verify/check.h"

#include <algorithm>

namespace symreal::program {
namespace {

class Outputs final : public Check {
public:
  Outputs(Subject &subject, Verification &result)
      : banner_(subject.banner),
        tolerance_(subject.options.tolerance),
        exact_(subject.graph),
        result_(result) {
    result_.outputs.resize(subject.graph.output_count());
    result_.lost.resize(subject.graph.output_count());
  }

  bool compare(CheckedSample const &on) override {
    bool is_worst = false;
    exact_.begin(on.sample.inputs, on.sample.parameters);
    for (std::size_t slot = 0; slot < on.original.size(); ++slot) {
      if (!on.single)
        is_worst |= add(result_.outputs[slot], on.number, slot, on.original[slot], on.generated[slot]);
      else if (on.single->lose(slot, on.original[slot], tolerance_))
        ++result_.lost[slot];
      else
        is_worst |= result_.outputs[slot].add_single(on.number, on.original[slot], on.generated[slot], tolerance_);
    }
    result_.graph_different += !all_same(on.original, on.recorded);
    return is_worst;
  }

  void finish() override { result_.exact = exact_.judgement(); }

private:
  // In mode fast a difference beyond the tolerance may be the original's own error.
  bool add(OutputComparison &output, std::size_t number, std::size_t slot, double original, double generated) {
    if (banner_.mode == FloatingPoint::fast && !same(original, generated, banner_.mode, tolerance_) &&
        exact_.accepts(slot, original, generated, tolerance_))
      return output.add_same(number, original, generated);
    return output.add(number, original, generated, banner_.mode, tolerance_);
  }

  Banner const &banner_;
  double tolerance_;
  ExactValues exact_;
  Verification &result_;
};

// The rewritten text must give the original's bits.
class Rewritten final : public Check {
public:
  Rewritten(std::unique_ptr<Replay> program, Verification &result) : program_(std::move(program)), result_(result) {}

  bool compare(CheckedSample const &on) override {
    return compare_outputs(result_.rewritten, on.number, on.original, program_->run(on.sample));
  }

private:
  std::unique_ptr<Replay> program_;
  Verification &result_;
};

// Flags of the user that may change numbers: distances are measured, not judged.
class OwnFlags final : public Check {
public:
  OwnFlags(Subject &subject, Verification &result)
      : subject_(subject),
        original_(subject.start("the original with its own flags", subject.front.own_flags_program)),
        result_(result) {
    result_.own_flags_ulp.resize(subject.graph.output_count());
    Front const &front = subject.front;
    if (front.own_flags.empty() || subject.in_program || !subject.banner.has_values) return;
    std::vector<char const *> words;
    for (std::string const &flag : front.own_flags) words.push_back(flag.c_str());
    code_.emplace(subject.path, subject.banner, subject.graph,
                  CodeBuild{front.build.c_compiler, front.build.compiler, words, "generated-own-flags.so"},
                  *front.build.cache, *front.workspace);
    result_.own_code_ulp.resize(subject.graph.output_count());
  }

  bool compare(CheckedSample const &on) override {
    keep_worst(result_.own_flags_ulp, original_->run(on.sample), on.generated);
    if (code_)
      keep_worst(result_.own_code_ulp, on.original,
                 code_->run(subject_.with_seeds(on.sample.inputs), on.sample.parameters).outputs);
    return false;
  }

private:
  static void keep_worst(std::vector<std::uint64_t> &worst, std::vector<double> const &one,
                         std::vector<double> const &other) {
    for (std::size_t slot = 0; slot < worst.size(); ++slot)
      worst[slot] = std::max(worst[slot], ulp_distance(one[slot], other[slot]));
  }

  Subject const &subject_;
  std::unique_ptr<Replay> original_;
  std::optional<GeneratedCode> code_;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_outputs(Subject &subject, Verification &result) {
  return std::make_unique<Outputs>(subject, result);
}

std::unique_ptr<Check> check_rewritten(Subject &subject, Verification &result) {
  result.rewritten.resize(subject.graph.output_count());
  if (!subject.has_original() || subject.front.replay_program.empty()) return nullptr;
  return std::make_unique<Rewritten>(subject.start("the rewritten program", subject.front.replay_program), result);
}

std::unique_ptr<Check> check_own_flags(Subject &subject, Verification &result) {
  if (subject.front.own_flags_program.empty() || subject.banner.is_single) return nullptr;
  return std::make_unique<OwnFlags>(subject, result);
}

} // namespace symreal::program
