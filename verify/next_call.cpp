// Check of the program's own next call of a kernel: exposes baked-in values that the program changes between calls.
#include "program/wrapper/wrapper_text.h"
#include "verify/check.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fmt/format.h>

namespace symreal::program {
namespace {

std::vector<std::string> words_of(std::string const &text) {
  std::vector<std::string> words(1);
  for (char const one : text)
    if (std::isalnum(static_cast<unsigned char>(one)) != 0 || one == '_')
      words.back() += one;
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

// Name of each parameter, or the last word of its declaration if it is unnamed or its declarator encloses the name.
std::vector<std::string> parameters_of(rewrite::Kernel const &kernel) {
  std::string const &text = kernel.signature.declaration;
  std::size_t begin = text.find(kernel.name + "(");
  std::vector<std::string> names;
  if (begin == text.npos) return {""};
  begin += kernel.name.size() + 1;
  std::size_t depth = 0, first = begin;
  for (std::size_t at = begin; at < text.size(); ++at) {
    char const one = text[at];
    bool const ends = depth == 0 && (one == ',' || one == ')');
    if (ends) {
      std::size_t const last = std::min(text.find_first_of("[=", first), at);
      std::vector<std::string> const words = words_of(text.substr(first, last - first));
      bool const is_none = words.empty() || (words.size() == 1 && words[0] == "void");
      if (!is_none) names.push_back(words.back());
      first = at + 1;
    }
    if (ends && one == ')') return names;
    if (one == '(' || one == '<' || one == '[') ++depth;
    if (depth != 0 && (one == ')' || one == '>' || one == ']')) --depth;
  }
  return {""};
}

// Time limits of the program's way to its next call, and of a sample: the next call may take twice the first one's.
constexpr unsigned seconds_to_reach = 7, seconds = 2;
constexpr std::size_t most_samples = 4;

// Must the next call be the recorded one on other inputs? True if nothing is declared constant or reported as baked in,
// the clauses name every argument, and the number of inputs determines their shapes.
bool is_next_call_comparable(Recorded const &recorded) {
  rewrite::Kernel const &kernel = recorded.kernel;
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  if (!kernel.is_function || function.has_this || !recorded.graph.frozen.empty()) return false;
  // Other shapes may have the same number of elements.
  if (!wrapper_containers(kernel, recorded.graph).empty()) return false;
  std::vector<std::string> named;
  auto const add = [&named](std::string const &text) {
    for (std::string &word : words_of(text)) named.push_back(std::move(word));
  };
  for (rewrite::Annotation const &one : kernel.annotations) {
    if (one.kind == "constant" || one.sections.size() > 1) return false;
    add(one.expression);
    for (rewrite::Section const &section : one.sections) add(section.low + " " + section.length);
  }
  auto const is_output = [&](std::string const &label) {
    return std::ranges::any_of(kernel.annotations,
                               [&](auto const &one) { return one.kind == "output" && one.label == label; });
  };
  bool const may_meet = std::ranges::any_of(
      function.overlaps, [&](rewrite::Overlap const &one) { return is_output(one.first) && is_output(one.second); });
  return !may_meet && std::ranges::all_of(parameters_of(kernel), [&](std::string const &one) {
    return std::ranges::find(named, one) != named.end();
  });
}

class NextCall final : public Check {
public:
  NextCall(Subject &subject, Verification &result) : subject_(subject), result_(result) {}

  bool compare(CheckedSample const &on) override {
    if (samples_.size() < most_samples) samples_.push_back(on.sample);
    return false;
  }

  void finish() override {
    if (samples_.empty()) return;
    wire::Request request;
    request.set(wire::Entry::later_call, "1");
    Replay next("the original in its next call", subject_.original_program, subject_.run, subject_.recorded.begun_as,
                subject_.recorded.graph, *subject_.front.workspace, nullptr, {}, std::move(request));
    if (std::optional<Outcome> const outcome = next.miss(seconds_to_reach))
      result_.next_call_missed = reason(*outcome);
    else
      result_.next_call_different = count_different(next);
  }

private:
  // Empty if the program ends as programs do.
  static std::string reason(Outcome const &outcome) {
    if (outcome.ending == Ending::timed_out)
      return fmt::format("the program does not come to it within {} s", seconds_to_reach);
    if (outcome.ending == Ending::signalled)
      return fmt::format("signal {} ({}) ends the program before it", outcome.status, strsignal(outcome.status));
    if (outcome.status != 0) return fmt::format("the program ends before it, with status {}", outcome.status);
    return {};
  }

  // 0 if the program passes overlapping arguments that lay apart, or ones of another shape.
  std::size_t count_different(Replay &next) {
    Replay &first = *subject_.original;
    std::size_t different = 0;
    for (Sample const &sample : samples_) {
      std::vector<double> original;
      try {
        (void)first.run(sample, {}, seconds);
      } catch (DiagnosticError const &) {
        return 0; // takes too long
      }
      try {
        original = next.run(sample, {}, 2 * seconds);
      } catch (DiagnosticError const &error) {
        if (next.state() == replay::State::inside)
          result_.next_call_ended = error.diagnostic().message;
        else if (next.state() != replay::State::wrong_shape)
          result_.next_call_missed = "its arguments cannot be read";
        return 0;
      }
      std::vector<double> const nothing(original.size(), 0);
      if (first.next_inputs(sample, nothing) != next.next_inputs(sample, nothing)) return 0;
      std::vector<double> const generated = subject_.code.run(sample.inputs, sample.parameters).outputs;
      different += !all_near(original, generated, subject_.banner.mode, subject_.options.tolerance);
    }
    return different;
  }

  Subject &subject_;
  std::vector<Sample> samples_;
  Verification &result_;
};

} // namespace

std::unique_ptr<Check> check_next_call(Subject &subject, Verification &result) {
  bool const is_plain = subject.banner.has_values && subject.banner.derivatives.empty() && subject.is_exact();
  if (!subject.has_original() || subject.in_program || !is_plain || subject.options.branches ||
      !is_next_call_comparable(subject.recorded))
    return nullptr;
  return std::make_unique<NextCall>(subject, result);
}

} // namespace symreal::program
