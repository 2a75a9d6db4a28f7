// Count of the branches of the original, by a build of it that counts them.
#include "verify/check.h"

namespace symreal::program {
namespace {

class Branches final : public Check {
public:
  Branches(Subject &subject, Verification &result)
      : annotated_(subject.front.annotated),
        kernel_(subject.recorded.kernel),
        run_{subject.front.covered.path, subject.front.workspace->file("branches"), {}, 0},
        program_(subject.start("the original that counts its branches", run_.program, nullptr, run_.profile)),
        result_(*result.branches) {}

  // A sample on which the counting build does not end says nothing about the generated code.
  bool compare(CheckedSample const &on) override {
    if (!program_) return false;
    try {
      program_->run(on.sample);
      ++run_.samples;
    } catch (DiagnosticError const &error) {
      result_.obstacle = error.diagnostic().message;
      program_.reset();
    }
    return false;
  }

  void finish() override {
    if (!program_) return;
    run_.stack = program_->stack();
    program_.reset(); // the program writes the counts when it ends
    result_ = read_branches(run_, annotated_, kernel_);
  }

private:
  rewrite::Result const &annotated_;
  rewrite::Kernel const &kernel_;
  CoveredRun run_;
  std::unique_ptr<Replay> program_;
  BranchResult &result_;
};

} // namespace

std::unique_ptr<Check> check_branches(Subject &subject, Verification &result) {
  if (!subject.options.branches) return nullptr;
  result.branches = BranchResult{subject.front.covered.obstacle, {}};
  return subject.front.covered.path.empty() ? nullptr : std::make_unique<Branches>(subject, result);
}

} // namespace symreal::program
