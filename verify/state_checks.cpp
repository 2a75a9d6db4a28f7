// Checks of state: memory that the original leaves changed, effects outside the program, and state that no clause
// names.
#include "verify/check.h"

#include "program/record/symbolize.h"
#include "runtime/memory/static_objects.h"

#include <algorithm>
#include <llvm/Demangle/Demangle.h>

namespace symreal::program {
namespace {

constexpr unsigned most_examined = 2; // samples

// Source name of a function's static variable; empty if the linker's name denotes something else.
std::string local_name(std::string const &linker_name) {
  if (linker_name.starts_with("_ZZ")) {
    std::string const name = llvm::demangle(linker_name);
    std::size_t const scope = name.rfind("::");
    return scope == name.npos ? "" : name.substr(scope + 2);
  }
  std::string const name = memory::name_in_c(linker_name);
  return name == linker_name ? "" : name;
}

bool is_scratch(std::vector<std::string> const &scratch, replay::LeftBehind const &left) {
  return left.region == memory::Region::static_object &&
         std::ranges::find(scratch, local_name(left.name)) != scratch.end();
}

class ChangedState final : public Check {
public:
  ChangedState(Subject &subject, Verification &result) : subject_(subject), result_(result) {}

  bool compare(CheckedSample const &on) override {
    for (replay::LeftBehind const &left : subject_.original->left_behind())
      if (!contains(on.left_by_generated, left) && !is_scratch(subject_.recorded.scratch, left))
        add_left(result_.left, describe(left));
    if (!subject_.in_program)
      for (replay::OutsideEffect const &effect : subject_.original->effects()) add_outside(effect);
    return false;
  }

private:
  // Effects that the recording already reports (frozen state) are skipped.
  void add_outside(replay::OutsideEffect const &effect) {
    if (effect.kind != replay::Outside::result)
      return add_left(effect.kind == replay::Outside::lasts ? result_.changes_outside : result_.outside, effect.what);
    bool const is_known =
        std::ranges::any_of(subject_.graph.frozen, [&](Frozen const &one) { return one.name == effect.what; });
    if (!is_known) add_left(result_.changes_outside, "reads '" + std::string(effect.what) + "'");
  }

  Subject const &subject_;
  Verification &result_;
};

// Runs the original with other bytes in the memory that it reads (runtime/replay/unnamed_state.h), on a few samples.
class UnnamedState final : public Check {
public:
  UnnamedState(Subject &subject, Verification &result)
      : subject_(subject),
        symbolizer_(subject.original_program, *subject.front.overlay),
        result_(result) {}

  bool compare(CheckedSample const &on) override {
    if (examined_ == most_examined) return false;
    ++examined_;
    std::vector<replay::UnnamedObject> const found = subject_.original->examine(on.sample);
    if (result_.unexamined.empty()) result_.unexamined = subject_.original->unexamined();
    for (replay::UnnamedObject const &one : found) {
      if (is_scratch(subject_.recorded.scratch, one.object)) continue;
      std::vector<Frame> const frames = symbolizer_.frames({one.instruction + 1});
      std::string const place = frames.empty() ? "" : " (" + to_string(frames.front().place) + ")";
      if (one.is_read == 0)
        add_left(result_.overwritten, describe(one.object) + place);
      else if (subject_.graph.frozen.empty()) // otherwise frozen state was accepted by the user
        add_left(result_.unnamed, describe(one.object) + place);
    }
    return false;
  }

private:
  Subject const &subject_;
  Symbolizer symbolizer_;
  unsigned examined_ = 0;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_left_state(Subject &subject, Verification &result) {
  return std::make_unique<ChangedState>(subject, result);
}

std::unique_ptr<Check> check_unnamed_state(Subject &subject, Verification &result) {
  if (subject.in_program) return nullptr;
  return std::make_unique<UnnamedState>(subject, result);
}

} // namespace symreal::program
