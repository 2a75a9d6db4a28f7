// Fields of what checks find, as JSON: of an output, of objects left behind, of branches, threads and errors.
#pragma once

#include "tool/report/json_fields.h"
#include "verify/verification.h"

#include <cmath>

namespace symreal {
namespace tool {

// Difference relative to the original.
inline double relative(double original, double generated) {
  return original == generated ? 0 : std::abs(generated - original) / std::abs(original);
}

} // namespace tool

// Descriptions stand beside their types, where argument-dependent lookup finds them.
using tool::Described;

template <class Fields> void describe(Fields &fields, Described<Fields, Member> &member) {
  fields("name", member.name, "extents", member.extents);
  tool::described_rows(fields, "members", member.members);
}

template <class Fields> void describe(Fields &fields, Described<Fields, Object> &object) {
  fields("label", object.label, "extents", object.extents);
  if (fields.has("members", !object.members.empty())) tool::described_rows(fields, "members", object.members);
  if (fields.has("place", !object.place.file.empty()))
    fields.object("place", [&](auto &place) {
      place("file", object.place.file, "line", object.place.line, "column", object.place.column);
    });
}

template <class Fields> void describe(Fields &fields, Described<Fields, Sample> &sample) {
  fields.numbers("inputs", sample.inputs);
  fields.numbers("parameters", sample.parameters);
}

template <class Fields> void describe(Fields &fields, Described<Fields, OutputComparison> &output) {
  fields("worst_ulp", output.worst_ulp, "different", output.different);
  if (fields.has("worst", output.has_worst()))
    fields.object("worst", [&](auto &worst) {
      worst("sample", output.worst_sample);
      worst.numbers("original", output.original);
      worst.numbers("generated", output.generated);
      worst.derived("relative", tool::number_json(tool::relative(output.original, output.generated)));
    });
}

namespace program {

template <class Fields> void describe(Fields &fields, Described<Fields, LeftState> &left) {
  fields("name", left.name, "samples", left.samples);
}

template <class Fields> void describe(Fields &fields, Described<Fields, GuardMismatch> &mismatch) {
  fields("sample", mismatch.sample, "expected", mismatch.expected, "found", mismatch.found);
}

template <class Fields> void describe(Fields &fields, Described<Fields, DecisionCoverage> &decision) {
  fields("place", decision.place);
  fields.mapped(
      "of", decision.is_guards, [](bool is_guards) { return is_guards ? "guard" : "select"; },
      [](auto const &json) { return json == "guard"; });
  fields("yes", decision.counts.yes, "no", decision.counts.no);
}

template <class Fields> void describe(Fields &fields, Described<Fields, BranchCount> &branch) {
  fields("place", branch.place, "condition", branch.condition);
  fields.unless(std::string(), "function", branch.function);
  fields("true", branch.yes, "false", branch.no);
}

template <class Fields> void describe(Fields &fields, Described<Fields, BranchResult> &result) {
  if (fields.has("obstacle", !result.obstacle.empty())) return fields("obstacle", result.obstacle);
  std::size_t const directions = 2 * result.branches.size();
  fields.derived("directions", directions);
  fields.derived("taken", directions - count_unseen(result.branches));
  tool::described_rows(fields, "counts", result.branches);
}

template <class Fields> void describe(Fields &fields, Described<Fields, ThreadResult> &result) {
  fields("threads", result.threads, "different", result.different);
  if (!result.times) return; // which are not read: they are of the run that measured them
  ThreadTimes const &times = *result.times;
  fields.object("nanoseconds", [&](auto &nanoseconds) {
    nanoseconds.derived("alone", times.alone);
    nanoseconds.derived("together", times.together);
    nanoseconds.derived("times_as_fast", std::vector{times.low, times.gain, times.high});
  });
}

template <class Fields> void describe(Fields &fields, Described<Fields, ErrorsOfOutput> &output) {
  fields("original", output.original, "generated", output.generated, "original_nearer", output.original_nearer,
         "generated_nearer", output.generated_nearer, "sample", output.worst_sample);
}

template <class Fields> void describe(Fields &fields, Described<Fields, ErrorResult> &result) {
  fields("bits", result.bits);
  fields.unless(std::string(), "obstacle", result.obstacle);
  fields("samples", result.samples, "untold", result.untold, "left_out", result.left_out);
  tool::described_rows(fields, "outputs", result.outputs);
}

} // namespace program

} // namespace symreal
