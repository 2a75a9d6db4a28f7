#include "tool/report/verify_report.h"

#include "engine/graph/extended.h"
#include "engine/graph/graph.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "tool/report/derivative_report.h"
#include "verify/exact_errors.h"
#include "verify/verification.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <limits>
#include <numeric>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace symreal::tool {
namespace {

std::string ulp_text(std::uint64_t distance) {
  return distance == std::numeric_limits<std::uint64_t>::max() ? "NaN" : std::to_string(distance);
}

// The worst element of an object: one that differs comes first, then the distance decides.
std::uint32_t worst_element(Object const &object, std::vector<OutputComparison> const &outputs) {
  auto key = [&](std::uint32_t element) {
    OutputComparison const &output = outputs[object.first + element];
    return std::pair(output.different != 0, output.worst_ulp);
  };
  std::uint32_t worst = 0;
  for (std::uint32_t element = 1; element < object.count; ++element)
    if (key(element) > key(worst)) worst = element;
  return worst;
}

std::size_t different_elements(Object const &object, std::vector<OutputComparison> const &outputs) {
  auto first = outputs.begin() + object.first;
  return static_cast<std::size_t>(
      std::count_if(first, first + object.count, [](OutputComparison const &output) { return output.different != 0; }));
}

// Column with the largest distance of an object; empty without distances.
std::string ulp_column(Object const &object, std::vector<std::uint64_t> const &ulp) {
  if (ulp.empty()) return "";
  auto const first = ulp.begin() + object.first;
  return fmt::format("{:>22}", ulp_text(*std::max_element(first, first + object.count)));
}

// Describes the worst element of the first object that differs. `what`: the side compared with the original.
std::string first_difference(Graph const &graph, program::Verification const &verification,
                             std::vector<OutputComparison> const &outputs, std::string_view what) {
  std::vector<std::string> names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    if (different_elements(object, outputs) == 0) continue;
    std::uint32_t element = worst_element(object, outputs);
    OutputComparison const &worst = outputs[object.first + element];
    return fmt::format("{}: original {}, {} {}, {} ULP apart, inputs {}", element_name(names[i], object, element),
                       shortest(worst.original), what, shortest(worst.generated), ulp_text(worst.worst_ulp),
                       number_list(verification.named.at(worst.worst_sample).inputs));
  }
  return {};
}

// Diagnostic for a fault of the rewriter, which masks all other differences.
std::optional<Diagnostic> rewriting_failure(Graph const &graph, program::Verification const &verification) {
  std::size_t const count = program::count_different(verification.rewritten);
  if (count == 0) return {};
  return Diagnostic{DiagnosticId::rewriting_mismatch,
                    graph.outputs.front().place,
                    fmt::format("kernel '{}': {} of {} outputs of the rewritten program differ from the original's",
                                graph.kernel, count, verification.rewritten.size()),
                    {{{}, first_difference(graph, verification, verification.rewritten, "rewritten")}}};
}

std::optional<Diagnostic> state_failure(Graph const &graph, std::vector<program::LeftState> const &all,
                                        std::string_view who) {
  if (all.empty()) return {};
  Diagnostic diagnostic{DiagnosticId::state_left_behind, graph.outputs.front().place, ""};
  for (program::LeftState const &left : all) {
    std::string const text = fmt::format("the {} leaves {} changed, on {} sample{}", who, left.name, left.samples,
                                         left.samples == 1 ? "" : "s");
    if (diagnostic.message.empty())
      diagnostic.message = fmt::format("kernel '{}': {}", graph.kernel, text);
    else
      diagnostic.notes.push_back({{}, text});
  }
  return diagnostic;
}

// Diagnostic for state that no clause names, which no comparison of numbers or memory reveals.
std::optional<Diagnostic> unnamed_failure(Graph const &graph, program::Verification const &verification) {
  std::optional<Diagnostic> diagnostic;
  auto const add = [&](DiagnosticId id, std::string const &text) {
    if (diagnostic)
      diagnostic->notes.push_back({{}, text});
    else
      diagnostic.emplace(id, graph.outputs.front().place, fmt::format("kernel '{}': {}", graph.kernel, text));
  };
  for (program::LeftState const &one : verification.unnamed)
    add(DiagnosticId::frozen_state, "the outputs of the original depend on " + one.name + ", which no clause names");
  for (program::LeftState const &one : verification.overwritten)
    add(DiagnosticId::state_left_behind, "the original overwrites " + one.name + " with the bytes that it holds");
  return diagnostic;
}

// Compresses runs: "1, 3-5, 8" for 1, 3, 4, 5, 8.
std::string runs_of(std::vector<std::size_t> const &numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    std::size_t const first = k;
    while (k + 1 < numbers.size() && numbers[k + 1] == numbers[k] + 1) ++k;
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[first]);
    if (k != first) text += (k == first + 1 ? ", " : "-") + std::to_string(numbers[k]);
  }
  return text;
}

void print_guards(std::ostream &out, program::Verification const &verification) {
  fmt::print(out, "  refused by a guard: {}\n  {:<8}{:>10}   {}\n", verification.refused, "guard", "samples",
             "condition");
  for (std::size_t k = 0; k < verification.guards.size(); ++k)
    fmt::print(out, "  {:<8}{:>10}   {}\n", k + 1, verification.guards[k].failed, verification.guards[k].text);
  std::vector<std::size_t> never;
  for (std::size_t k = 0; k < verification.guards.size(); ++k)
    if (verification.guards[k].failed == 0) never.push_back(k + 1);
  if (!never.empty())
    fmt::print(out,
               "  no sample failed guard {}, so its other side was not tested; range(low, high) on an input says "
               "where samples are drawn\n",
               runs_of(never));
  if (verification.mode == FloatingPoint::fast && verification.guards_different != 0)
    fmt::print(out, "  rounding changes the decisions of {} samples\n", verification.guards_different);
}

// Prints the decisions with one outcome only. The other side of a guard is refused, and listed with the guards.
void print_decisions(std::ostream &out, program::Verification const &verification) {
  std::size_t const both = static_cast<std::size_t>(
      std::ranges::count_if(verification.decisions, [](program::DecisionCoverage const &decision) {
        return decision.counts.yes != 0 && decision.counts.no != 0;
      }));
  fmt::print(out, "  decisions: {} of {} went both ways", both, verification.decisions.size());
  if (verification.around != 0)
    fmt::print(out, "; samples stand on both sides of the boundaries of {}", verification.crossed);
  fmt::print(out, "\n");
  constexpr std::size_t most = 16;
  std::size_t told = 0;
  for (program::DecisionCoverage const &decision : verification.decisions) {
    auto const &[yes, no] = decision.counts;
    if (yes != 0 && no != 0) continue;
    if (++told > most) continue;
    fmt::print(out, "    {}: {}\n", decision.place,
               yes + no == 0 ? "never met"
                             : fmt::format("always {}, in {} sample{}", yes == 0 ? "false" : "true", yes + no,
                                           yes + no == 1 ? "" : "s"));
  }
  if (told > most) fmt::print(out, "    and {} more\n", told - most);
}

// Prints the branches of the original that went one way only, however the recording treats them.
void print_branches(std::ostream &out, program::BranchResult const &result) {
  if (!result.obstacle.empty()) {
    fmt::print(out, "  branches of the original: not counted: {}\n", result.obstacle);
    return;
  }
  std::size_t const directions = 2 * result.branches.size(), unseen = program::count_unseen(result.branches);
  fmt::print(out, "  branches of the original: {} of {} directions taken by some sample\n", directions - unseen,
             directions);
  for (program::BranchCount const &branch : result.branches) {
    if (branch.yes != 0 && branch.no != 0) continue;
    std::string_view const what = branch.yes + branch.no == 0 ? "never met"
                                  : branch.yes == 0           ? "never true"
                                                              : "never false";
    fmt::print(out, "    {}: {}: {}{}\n", branch.place, what, branch.condition,
               branch.function.empty() ? "" : ", in " + branch.function);
  }
}

// Prints the numbers and samples left out because single precision cannot judge them.
void print_single(std::ostream &out, program::Verification const &verification) {
  fmt::print(out, "  single precision: compared to {} of the larger of the original's magnitude and 1\n",
             shortest(verification.tolerance));
  if (verification.decided_otherwise != 0)
    fmt::print(out, "  decided otherwise: {} samples on which float rounds a decision the other way\n",
               verification.decided_otherwise);
  std::size_t const lost = std::accumulate(verification.lost.begin(), verification.lost.end(), std::size_t{0});
  if (lost != 0)
    fmt::print(out, "  left out: {} of {} numbers, of which float itself loses more than a quarter of that\n", lost,
               verification.inside * verification.lost.size());
}

// Prints the outputs that are accepted because the original itself is inaccurate.
void print_exact(std::ostream &out, Graph const &graph, program::ExactJudgement const &exact) {
  std::size_t numbers = 0;
  for (program::OutputErrors const &output : exact.outputs) numbers += output.calls;
  if (numbers == 0) return;
  fmt::print(out,
             "  judged in {} bits: {} numbers of {} calls, which are farther than the tolerance from the original's, "
             "but no farther from the exact ones than {} times the original's and the tolerance\n",
             extended_bits, numbers, exact.calls, most_times_as_far);
  std::vector<std::string> const names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    for (std::uint32_t element = 0; element < object.count; ++element)
      if (program::OutputErrors const &errors = exact.outputs[object.first + element]; errors.calls != 0)
        fmt::print(out, "    {:<26}{:>10} calls: off by at most {:.1e}, the original by {:.1e}\n",
                   element_name(names[i], object, element), errors.calls, errors.generated, errors.original);
  }
}

// Notes the verdict of extended precision on a difference, or why it could not judge.
void add_exact_notes(Diagnostic &diagnostic, program::ExactJudgement const &exact) {
  auto const add = [&](std::string note) { diagnostic.notes.push_back({{}, std::move(note)}); };
  if (!exact.obstacle.empty())
    return add("extended precision cannot tell which of them is nearer to the exact value: " + exact.obstacle);
  if (exact.untold != 0)
    add(fmt::format("in {} calls extended precision does not tell which of them is nearer to the exact value, since a "
                    "decision falls otherwise there",
                    exact.untold));
  auto const worst = std::ranges::max_element(exact.outputs, {}, &program::OutputErrors::failed_generated);
  if (worst != exact.outputs.end() && worst->failed_generated != 0)
    add(fmt::format("in extended precision the original is off by {:.1e}, the generated code by {:.1e}: more than {} "
                    "times as far and the tolerance",
                    worst->failed_original, worst->failed_generated, most_times_as_far));
}

std::string guard_difference(program::Verification const &verification) {
  if (!verification.guard_mismatch) return {};
  program::GuardMismatch const &mismatch = *verification.guard_mismatch;
  return fmt::format("the original {}, the code returned {}, inputs {}",
                     mismatch.expected.empty() ? "decides as it did while it was recorded"
                                               : "does not satisfy the guard " + mismatch.expected,
                     mismatch.found, number_list(verification.named.at(mismatch.sample).inputs));
}

// Minimum number of samples inside; 0 for a shard, as others may have them, and for samples chosen by the user.
std::size_t wanted_samples(program::Verification const &verification, program::VerificationOptions const &options) {
  bool const is_whole = options.shard.count == 1 && options.replayed.empty();
  return is_whole ? std::min({options.min_samples, options.samples, verification.tried}) : 0;
}

// Prints the errors of the original and of the generated code against exact values.
void print_errors(std::ostream &out, Graph const &graph, program::ErrorResult const &result) {
  fmt::print(out, "  exact values, in {} bits: ", result.bits);
  if (!result.obstacle.empty()) return fmt::print(out, "there are none: {}\n", result.obstacle);
  fmt::print(
      out, "{} sample{}{}{}\n", result.samples, result.samples == 1 ? "" : "s",
      result.untold == 0
          ? ""
          : fmt::format("; {} more, where a decision falls otherwise in them or a value is not finite", result.untold),
      result.left_out == 0 ? "" : fmt::format("; {} more were left out, for the time they take", result.left_out));
  if (result.samples == 0) return;
  fmt::print(out, "    {:<26}{:>22}{:>20}{:>36}\n", "error of", "the original, at most", "the code, at most",
             "nearer on: the original, the code");
  std::vector<std::string> const names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    if (object.count == 0) continue;
    auto const first = result.outputs.begin() + object.first;
    auto const worst = std::max_element(first, first + object.count, [](auto const &one, auto const &other) {
      return std::max(one.original, one.generated) < std::max(other.original, other.generated);
    });
    fmt::print(out, "    {:<26}{:>22.1e}{:>20.1e}{:>36}\n",
               element_name(names[i], object, static_cast<std::uint32_t>(worst - first)), worst->original,
               worst->generated, fmt::format("{}, {}", worst->original_nearer, worst->generated_nearer));
  }
}

void print_threads(std::ostream &out, program::ThreadResult const &result) {
  fmt::print(out, "  {} threads share an evaluation, and one computes the same numbers on {}", result.threads,
             result.different == 0 ? "all samples" : fmt::format("all samples but {}", result.different));
  if (!result.times) {
    fmt::print(out, "; not timed\n");
    return;
  }
  program::ThreadTimes const &times = *result.times;
  fmt::print(
      out,
      "\n  it takes {:.3g} us in place of {:.3g} us: {:.2f} times as fast ({:.2f} to {:.2f}, quartiles of {} turns)\n",
      times.together / 1e3, times.alone / 1e3, times.gain, times.low, times.high, times.turns);
}

// Diagnostic if threads that share an evaluation compute other numbers than one.
std::optional<Diagnostic> thread_failure(program::Verification const &verification, std::string const &file) {
  if (!verification.threads || verification.threads->different == 0) return {};
  return Diagnostic{DiagnosticId::verification_mismatch,
                    {file},
                    fmt::format("on {} samples {} threads compute other numbers than one",
                                verification.threads->different, verification.threads->threads)};
}

void print_comparisons(std::ostream &out, Graph const &graph, program::Verification const &verification) {
  fmt::print(out, "kernel {}, mode {}{}: {} sample{}{}, {} within the premises\n", graph.kernel,
             to_string(verification.mode), verification.is_single ? ", float" : "",
             verification.tried - verification.around, verification.tried - verification.around == 1 ? "" : "s",
             verification.around == 0 ? "" : fmt::format(" and {} around decisions", verification.around),
             verification.inside);
  if (verification.undefined != 0)
    fmt::print(out,
               "  left out: {} on which the original's behaviour is undefined: an index outside of its table, an "
               "integer beyond its type, or the sign of a NaN\n",
               verification.undefined);
  if (verification.not_finite + verification.zero_sign != 0)
    fmt::print(out,
               "  outside: {} with a value that is not finite, {} where the sign of a zero is seen; {} of them "
               "differ\n",
               verification.not_finite, verification.zero_sign, verification.outside_different);
  if (verification.is_single) print_single(out, verification);
  if (!verification.guards.empty()) print_guards(out, verification);
  if (verification.guards.empty() && program::explore_bounds(graph.decisions))
    out << "  every path is recorded: no sample is left to a guard\n";
  if (!verification.decisions.empty()) print_decisions(out, verification);
  if (verification.branches) print_branches(out, *verification.branches);
  if (verification.threads) print_threads(out, *verification.threads);
  print_exact(out, graph, verification.exact);
  if (verification.errors) print_errors(out, graph, *verification.errors);
  for (program::LeftState const &effect : verification.outside)
    fmt::print(out, "  outside of the program: the original {}, and the generated code does not\n", effect.name);
  if (!verification.unexamined.empty())
    fmt::print(out, "  state that no clause names: not all was looked at: {}\n", verification.unexamined);
  if (!verification.next_call_missed.empty())
    fmt::print(out, "  the program's next call was not compared: {}\n", verification.next_call_missed);
  if (!verification.wrapped.empty()) fmt::print(out, "  the wrapper was tried as well\n");
  if (verification.derivatives && !verification.has_values) return print_derivatives(out, *verification.derivatives);
  fmt::print(out, "  {:<28}{:>10}{:>22}{:>12}{}{}\n", "output", "elements",
             verification.is_single ? "worst ULP of float" : "worst ULP", "different",
             verification.own_flags_ulp.empty() ? "" : fmt::format("{:>22}", "ULP, own flags"),
             verification.own_code_ulp.empty() ? "" : fmt::format("{:>22}", "code with own flags"));
  std::vector<std::string> names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    if (object.count == 0) continue;
    std::uint32_t element = worst_element(object, verification.outputs);
    fmt::print(out, "  {:<28}{:>10}{:>22}{:>12}{}{}\n", element_name(names[i], object, element), object.count,
               ulp_text(verification.outputs[object.first + element].worst_ulp),
               different_elements(object, verification.outputs), ulp_column(object, verification.own_flags_ulp),
               ulp_column(object, verification.own_code_ulp));
  }
  if (verification.derivatives) print_derivatives(out, *verification.derivatives);
}

} // namespace

void print_verification(std::ostream &out, Graph const &graph, program::Verification const &verification) {
  print_comparisons(out, graph, verification);
  if (!verification.mathematics.empty()) fmt::print(out, "  functions of the original: {}\n", verification.mathematics);
}

std::optional<Diagnostic> verification_failure(Graph const &graph, program::Verification const &verification,
                                               program::VerificationOptions const &options, std::string const &file) {
  if (auto failure = rewriting_failure(graph, verification)) return failure;
  if (std::size_t count = program::count_different(verification.outputs)) {
    Diagnostic diagnostic{DiagnosticId::verification_mismatch, {file}, ""};
    diagnostic.message = fmt::format("{} of {} outputs differ from the original", count, verification.outputs.size());
    diagnostic.notes.push_back({{}, first_difference(graph, verification, verification.outputs, "generated")});
    if (verification.graph_different != 0)
      diagnostic.notes.push_back(
          {{},
           fmt::format(
               "on {} samples the recorded graph, before any pass, differs from the original too: the cause is not "
               "a pass but what the recording did not see (state other than inputs, a decision that was carried, "
               "code that was not rewritten)",
               verification.graph_different)});
    if (verification.mode == FloatingPoint::fast) add_exact_notes(diagnostic, verification.exact);
    return diagnostic;
  }
  if (std::size_t count = program::count_different(verification.called_again))
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("called again, {} of {} outputs differ from the original: it keeps something other "
                                  "than its outputs, or that is said to be scratch",
                                  count, verification.outputs.size()),
                      {{{}, first_difference(graph, verification, verification.called_again, "generated")}}};
  if (std::size_t count = program::count_different(verification.called_beyond))
    return Diagnostic{
        DiagnosticId::verification_mismatch,
        {file},
        fmt::format("where a guard fails, {} of {} outputs of the original depend on the calls before: it "
                    "keeps something that the generated code does not",
                    count, verification.outputs.size()),
        {{{}, first_difference(graph, verification, verification.called_beyond, "without these calls")}}};
  if (!verification.next_call_ended.empty())
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("{}, where the recorded call returns: it reads something that the recording has "
                                  "baked in, and that the program changes",
                                  verification.next_call_ended)};
  if (verification.next_call_different != 0)
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("in the program's next call the original gives other outputs on {} samples: it reads "
                                  "something that the recording has baked in, and that the program changes",
                                  verification.next_call_different)};
  if (auto failure = thread_failure(verification, file)) return failure;
  if (verification.guards_different != 0 && verification.mode != FloatingPoint::fast)
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("on {} samples the code does not return the guard that does not hold",
                                  verification.guards_different),
                      {{{}, guard_difference(verification)}}};
  if (auto failure = state_failure(graph, verification.left, "original")) return failure;
  if (auto failure = unnamed_failure(graph, verification)) return failure;
  if (!verification.changes_outside.empty())
    return Diagnostic{DiagnosticId::effect_outside, graph.outputs.front().place,
                      fmt::format("kernel '{}': the original {}, and the generated code does not", graph.kernel,
                                  verification.changes_outside[0].name)};
  if (std::size_t count = program::count_different(verification.wrapped))
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("{} of {} outputs of the wrapper differ from the generated code's", count,
                                  verification.outputs.size()),
                      {{{}, first_difference(graph, verification, verification.wrapped, "wrapper's")}}};
  if (auto failure = state_failure(graph, verification.left_by_wrapper, "wrapper")) return failure;
  if (!verification.missed_by_wrapper.empty())
    return Diagnostic{DiagnosticId::verification_mismatch,
                      {file},
                      fmt::format("the wrapper gives other results than the original {}",
                                  verification.missed_by_wrapper.front().name)};
  std::size_t const wanted = wanted_samples(verification, options);
  if (verification.inside < wanted)
    return Diagnostic{DiagnosticId::too_few_samples,
                      {file},
                      fmt::format("only {} samples lie within the premises of mode {}, and {} are required",
                                  verification.inside, to_string(verification.mode), wanted)};
  std::size_t const lost = verification.is_single ? *std::ranges::max_element(verification.lost) : 0;
  if (verification.inside - lost < wanted)
    return Diagnostic{DiagnosticId::too_few_samples,
                      {file},
                      fmt::format("only {} samples can be compared in single precision, and {} are required: --tol {} "
                                  "asks for more than float holds of the others",
                                  verification.inside - lost, wanted, verification.tolerance)};
  return verification.derivatives ? derivative_failure(*verification.derivatives, file, options.shard.count == 1)
                                  : std::nullopt;
}

} // namespace symreal::tool
