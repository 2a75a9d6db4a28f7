// Fields of a verification record, and of the results in it, as JSON.
#include "engine/graph/extended.h"
#include "engine/graph/names.h"
#include "tool/report/derivative_report.h"
#include "tool/report/result_fields.h"
#include "tool/report/verification_record.h"

#include <algorithm>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

// The comparisons that are not equal.
bool is_unequal(OutputComparison const &output) { return output.has_worst(); }

// A member of the elements of a vector that is empty or has one for each output.
template <class Fields, class Numbers>
void describe_element(Fields &row, char const *key, Numbers &numbers, std::size_t k) {
  if (!row.has(key, !numbers.empty())) return;
  if constexpr (Fields::reads) numbers.emplace_back();
  row(key, numbers.at(k));
}

template <class Fields, class Comparisons>
void describe_comparisons(Fields &fields, char const *key, Comparisons &outputs) {
  fields.sparse(key, outputs, is_unequal, [](auto &row, auto const &output, std::size_t &slot) {
    row("slot", slot);
    describe(row, output());
  });
}

// A result that is absent if it was not asked for.
template <class Fields, class T> void describe_optional(Fields &fields, char const *key, T &result) {
  if (!fields.has(key, result.has_value())) return;
  if constexpr (Fields::reads) result.emplace();
  fields.object(key, [&](auto &inner) { describe(inner, *result); });
}

template <class Fields, class Rows> void describe_unless_empty(Fields &fields, char const *key, Rows &rows) {
  if (fields.has(key, !rows.empty())) described_rows(fields, key, rows);
}

// The outputs on which an exact value was asked for.
template <class Fields, class Exact>
void describe_exact(Fields &fields, std::vector<Object> const &objects, Exact &exact) {
  fields.derived("bits", extended_bits);
  fields.derived("times_as_far", most_times_as_far);
  fields("calls", exact.calls, "untold", exact.untold);
  auto const is_judged = [](program::OutputErrors const &errors) {
    return errors.calls != 0 || errors.failed_generated != 0;
  };
  fields.sparse("outputs", exact.outputs, is_judged, [&](auto &row, auto const &output, std::size_t &slot) {
    auto object = std::ranges::find_if(objects, [&](Object const &one) { return slot - one.first < one.count; });
    std::string label = object == objects.end() ? "" : object->label;
    std::size_t element = object == objects.end() ? 0 : slot - object->first;
    row("label", label, "element", element);
    object = std::ranges::find(objects, label, &Object::label);
    if (object == objects.end()) throw std::invalid_argument("no object");
    slot = object->first + element;
    auto &errors = output();
    row("calls", errors.calls, "error", errors.generated, "original_error", errors.original);
    if (!row.has("failed_error", errors.failed_generated != 0)) return;
    row.numbers("failed_error", errors.failed_generated);
    row.numbers("failed_original_error", errors.failed_original);
  });
  fields.unless(std::string(), "obstacle", exact.obstacle);
}

template <class Fields, class Verification>
void describe_outputs(Fields &fields, Graph const &graph, Verification &verification) {
  std::vector<std::string> const names = Fields::reads ? std::vector<std::string>() : identifiers(graph.outputs);
  std::size_t at = 0; // object of the row
  fields.rows("outputs", verification.outputs, [&](auto &row, auto &output, std::size_t slot) {
    if constexpr (!Fields::reads) {
      while (slot - graph.outputs[at].first >= graph.outputs[at].count) ++at;
      Object const &object = graph.outputs[at];
      auto const element = static_cast<std::uint32_t>(slot - object.first);
      row.derived("label", object.label);
      row.derived("element", element);
      row.derived("name", element_name(names[at], object, element));
    }
    describe(row, output);
    describe_element(row, "own_flags_ulp", verification.own_flags_ulp, slot);
    describe_element(row, "own_code_ulp", verification.own_code_ulp, slot);
  });
}

template <class Fields, class Verification> void describe_guards(Fields &fields, Verification &verification) {
  if (!fields.has("guards", !verification.guards.empty())) return;
  fields("refused", verification.refused, "guards_different", verification.guards_different);
  describe_optional(fields, "guard_mismatch", verification.guard_mismatch);
  std::size_t evaluated = verification.inside + verification.refused; // a guard is evaluated if those before it hold
  fields.rows("guards", verification.guards, [&](auto &row, auto &guard, std::size_t) {
    row("text", guard.text);
    row.derived("evaluated", evaluated);
    row("failed", guard.failed);
    evaluated -= std::min(guard.failed, evaluated);
  });
}

// Samples that other members refer to.
template <class Fields, class Named> void describe_named(Fields &fields, Named &named) {
  std::vector<std::pair<std::size_t, Sample>> all(named.begin(), named.end());
  auto const visit = [](auto &row, auto &one, std::size_t) {
    row("sample", one.first);
    describe(row, one.second);
  };
  fields.rows("named", all, visit);
  if constexpr (Fields::reads) named = {all.begin(), all.end()};
}

// The sample of a derivative's element.
template <class Fields, class Pointer> void describe_sample(Fields &fields, Pointer &sample) {
  fields.object("sample", [&](auto &inner) {
    Sample read = sample ? *sample : Sample();
    describe(inner, read);
    if constexpr (Fields::reads) sample = std::make_shared<Sample const>(std::move(read));
  });
}

template <class Fields, class Element> void describe_element_of_derivative(Fields &row, Element &element) {
  row("judged", element.judged, "different", element.different, "different_from_formulas", element.broken);
  row.numbers("worst_error_by_allowed", element.error);
  if (row.has("worst", element.different != 0))
    row.object("worst", [&](auto &worst) {
      worst("by_differences", element.is_by_differences);
      worst.numbers("expected", element.expected);
      worst.numbers("found", element.found);
      describe_sample(worst, element.worst);
    });
  if (row.has("off_formulas", element.broken != 0))
    row.object("off_formulas", [&](auto &formulas) {
      formulas.numbers("expected", element.promised);
      formulas.numbers("found", element.given);
      describe_sample(formulas, element.first_broken);
    });
}

// `next`: the slot behind the kernel's own outputs.
template <class Fields, class Result> void describe_derivatives(Fields &fields, std::size_t next, Result &result) {
  fields("samples", result.tried, "samples_compared_with_formulas", result.promised, "samples_left_out",
         result.left_out, "tolerance", result.tolerance);
  fields.rows("objects", result.objects, [&](auto &row, auto &object, std::size_t) {
    row("label", object.label, "extents", object.extents);
    if constexpr (Fields::reads) {
      object.first = static_cast<std::uint32_t>(next);
      object.count = static_cast<std::uint32_t>(number_count(object.extents, {}));
      next += object.count;
    }
  });
  fields.rows("elements", result.elements, [&](auto &row, auto &element, std::size_t k) {
    if constexpr (!Fields::reads) row.derived("name", name_of(result, k));
    describe_element_of_derivative(row, element);
  });
}

// Lays out the slots of the objects that were read, and results for each slot.
void begin_slots(VerificationRecord &record) {
  std::uint32_t first = 0;
  for (Object &object : record.graph.outputs) {
    object.first = first;
    object.count = static_cast<std::uint32_t>(number_count(object.extents, object.members));
    first += object.count;
  }
  program::Verification &verification = record.verification;
  verification.exact.outputs.resize(first);
  verification.lost.resize(first);
  for (auto *outputs : {&verification.rewritten, &verification.called_again, &verification.called_beyond})
    outputs->resize(first);
}

// Throws std::invalid_argument for results of other slots than those of the objects.
void require_slots(VerificationRecord const &record) {
  program::Verification const &verification = record.verification;
  std::size_t const count = record.graph.output_count();
  if (verification.outputs.size() != count) throw std::invalid_argument("outputs without objects");
  if (verification.errors && verification.errors->outputs.size() != count)
    throw std::invalid_argument("outputs without objects");
  if (!verification.derivatives) return;
  program::DerivativeResult const &derivatives = *verification.derivatives;
  std::size_t elements = 0;
  for (Object const &object : derivatives.objects) elements += object.count;
  if (derivatives.objects.empty() || derivatives.elements.size() != elements)
    throw std::invalid_argument("no derivatives");
}

} // namespace

template <class Fields> void describe(Fields &fields, Described<Fields, VerificationRecord> &record) {
  auto &verification = record.verification;
  auto &options = record.options;
  auto &objects = record.graph.outputs;
  fields("kernel", record.graph.kernel, "file", record.file);
  fields.mapped(
      "mode", verification.mode, [](FloatingPoint mode) { return to_string(mode); },
      [](Json const &json) {
        if (auto const mode = parse_floating_point(json.get<std::string>())) return *mode;
        throw std::invalid_argument("no mode");
      });
  fields.lenient("mathematics", verification.mathematics); // a certificate has it in another place
  fields("tolerance", verification.tolerance, "drawn", options.samples, "min_samples", options.min_samples, "seed",
         options.seed);
  fields.object("shards", [&](auto &shards) {
    shards("count", options.shard.count);
    std::vector<std::size_t> numbers = record.shards; // from 1
    for (std::size_t &number : numbers) ++number;
    shards("done", numbers);
    if constexpr (Fields::reads)
      for (std::size_t const number : numbers) record.shards.push_back(number - 1);
  });
  fields("samples", verification.tried, "inside", verification.inside, "not_finite", verification.not_finite,
         "zero_sign", verification.zero_sign, "undefined", verification.undefined, "outside_different",
         verification.outside_different, "graph_different", verification.graph_different, "around", verification.around,
         "crossed", verification.crossed);
  described_rows(fields, "objects", objects);
  if constexpr (Fields::reads) begin_slots(record);
  describe_outputs(fields, record.graph, verification);
  if (fields.has("real", verification.is_single)) {
    fields.derived("real", "float");
    if constexpr (Fields::reads) verification.is_single = true;
    fields("decided_otherwise", verification.decided_otherwise, "lost", verification.lost);
  }
  if (fields.has("derivatives", verification.derivatives.has_value())) {
    if constexpr (Fields::reads) verification.derivatives.emplace();
    fields.object("derivatives", [&](auto &inner) {
      describe_derivatives(inner, record.graph.output_count(), *verification.derivatives);
    });
  }
  fields.unless(true, "has_values", verification.has_values);
  describe_optional(fields, "parallel", verification.threads);
  if (fields.has("extended", verification.exact.calls != 0))
    fields.object("extended", [&](auto &inner) { describe_exact(inner, objects, verification.exact); });
  fields.derived("rewritten_different", program::count_different(verification.rewritten));
  fields.derived("called_again_different", program::count_different(verification.called_again));
  describe_comparisons(fields, "rewritten", verification.rewritten);
  describe_comparisons(fields, "called_again", verification.called_again);
  if (fields.has("called_beyond", program::count_different(verification.called_beyond) != 0))
    describe_comparisons(fields, "called_beyond", verification.called_beyond);
  if (fields.has("wrapped", !verification.wrapped.empty())) {
    if constexpr (Fields::reads) verification.wrapped.resize(verification.outputs.size());
    describe_comparisons(fields, "wrapped", verification.wrapped);
  }
  described_rows(fields, "left_behind", verification.left);
  described_rows(fields, "left_by_wrapper", verification.left_by_wrapper);
  describe_unless_empty(fields, "unnamed", verification.unnamed);
  describe_unless_empty(fields, "overwritten", verification.overwritten);
  fields.unless(std::string(), "unexamined", verification.unexamined);
  describe_unless_empty(fields, "changes_outside", verification.changes_outside);
  fields.unless(std::size_t{0}, "next_call_different", verification.next_call_different);
  fields.unless(std::string(), "next_call_ended", verification.next_call_ended);
  fields.unless(std::string(), "next_call_missed", verification.next_call_missed);
  describe_unless_empty(fields, "outside", verification.outside);
  describe_unless_empty(fields, "missed_by_wrapper", verification.missed_by_wrapper);
  describe_guards(fields, verification);
  described_rows(fields, "decisions", verification.decisions);
  describe_optional(fields, "branches", verification.branches);
  describe_optional(fields, "errors", verification.errors);
  describe_named(fields, verification.named);
}

Json to_json(VerificationRecord const &record) {
  Json json = Json::object();
  WrittenFields fields(json);
  describe(fields, record);
  return json;
}

VerificationRecord record_of(Json const &json) {
  VerificationRecord record;
  ReadFields fields(json);
  describe(fields, record);
  record.options.tolerance = record.verification.tolerance;
  require_slots(record);
  return record;
}

} // namespace symreal::tool
