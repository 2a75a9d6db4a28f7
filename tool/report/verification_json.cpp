// Conversion of verification records to JSON and back. Numbers that JSON lacks are strings: "nan", "inf", "-inf".
#include "engine/graph/extended.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "tool/report/derivative_report.h"
#include "tool/report/verification_record.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

Json members_json(std::vector<Member> const &members) {
  Json json = Json::array();
  for (Member const &member : members)
    json.push_back({{"name", member.name}, {"extents", member.extents}, {"members", members_json(member.members)}});
  return json;
}

std::vector<Member> members_of(Json const &json) {
  std::vector<Member> members;
  for (Json const &one : json)
    members.push_back(
        {one.at("name"), one.at("extents").get<std::vector<std::size_t>>(), members_of(one.at("members"))});
  return members;
}

Json object_json(Object const &object) {
  Json json = {{"label", object.label}, {"extents", object.extents}};
  if (!object.members.empty()) json["members"] = members_json(object.members);
  if (!object.place.file.empty())
    json["place"] = {{"file", object.place.file}, {"line", object.place.line}, {"column", object.place.column}};
  return json;
}

std::vector<Object> objects_of(Json const &json) {
  std::vector<Object> objects;
  std::uint32_t first = 0;
  for (Json const &one : json) {
    Object object{one.at("label"), one.at("extents").get<std::vector<std::size_t>>(), first};
    object.members = members_of(one.value("members", Json::array()));
    object.count = static_cast<std::uint32_t>(number_count(object.extents, object.members));
    if (one.contains("place"))
      object.place = {one["place"].at("file"), one["place"].at("line"), one["place"].at("column")};
    first += object.count;
    objects.push_back(std::move(object));
  }
  return objects;
}

// Difference relative to the original.
double relative(double original, double generated) {
  return original == generated ? 0 : std::abs(generated - original) / std::abs(original);
}

void add_worst(Json &json, OutputComparison const &output) {
  if (!output.has_worst()) return;
  json["worst"] = {{"sample", output.worst_sample},
                   {"original", number_json(output.original)},
                   {"generated", number_json(output.generated)},
                   {"relative", number_json(relative(output.original, output.generated))}};
}

void read_comparison(Json const &json, OutputComparison &output) {
  output.different = json.at("different");
  output.worst_ulp = json.at("worst_ulp");
  if (!json.contains("worst")) return;
  output.worst_sample = json["worst"].at("sample");
  output.original = number_of(json["worst"].at("original"));
  output.generated = number_of(json["worst"].at("generated"));
}

// Comparisons of the outputs that are not equal, by slot.
Json comparisons_json(std::vector<OutputComparison> const &outputs) {
  Json json = Json::array();
  for (std::size_t slot = 0; slot < outputs.size(); ++slot)
    if (outputs[slot].has_worst()) {
      json.push_back({{"slot", slot}, {"worst_ulp", outputs[slot].worst_ulp}, {"different", outputs[slot].different}});
      add_worst(json.back(), outputs[slot]);
    }
  return json;
}

std::vector<OutputComparison> comparisons_of(Json const &json, std::size_t count) {
  std::vector<OutputComparison> outputs(count);
  for (Json const &one : json) read_comparison(one, outputs.at(one.at("slot")));
  return outputs;
}

Json left_json(std::vector<program::LeftState> const &all) {
  Json json = Json::array();
  for (program::LeftState const &left : all) json.push_back({{"name", left.name}, {"samples", left.samples}});
  return json;
}

std::vector<program::LeftState> left_of(Json const &json) {
  std::vector<program::LeftState> all;
  for (Json const &one : json) all.push_back({one.at("name"), one.at("samples")});
  return all;
}

Json exact_json(Graph const &graph, program::ExactJudgement const &exact) {
  Json json = {{"bits", extended_bits},
               {"times_as_far", most_times_as_far},
               {"calls", exact.calls},
               {"untold", exact.untold},
               {"outputs", Json::array()}};
  if (!exact.obstacle.empty()) json["obstacle"] = exact.obstacle;
  for (Object const &object : graph.outputs)
    for (std::uint32_t element = 0; element < object.count; ++element) {
      program::OutputErrors const &errors = exact.outputs[object.first + element];
      if (errors.calls == 0 && errors.failed_generated == 0) continue;
      json["outputs"].push_back({{"label", object.label},
                                 {"element", element},
                                 {"calls", errors.calls},
                                 {"error", errors.generated},
                                 {"original_error", errors.original}});
      if (errors.failed_generated != 0) {
        json["outputs"].back()["failed_error"] = number_json(errors.failed_generated);
        json["outputs"].back()["failed_original_error"] = number_json(errors.failed_original);
      }
    }
  return json;
}

program::ExactJudgement exact_of(Json const &json, Graph const &graph) {
  program::ExactJudgement exact;
  exact.outputs.resize(graph.output_count());
  if (!json.is_object()) return exact;
  exact.calls = json.at("calls");
  exact.untold = json.at("untold");
  exact.obstacle = json.value("obstacle", "");
  for (Json const &one : json.at("outputs")) {
    auto const object = std::ranges::find(graph.outputs, one.at("label").get<std::string>(), &Object::label);
    if (object == graph.outputs.end()) throw std::invalid_argument("no object");
    program::OutputErrors &errors = exact.outputs.at(object->first + one.at("element").get<std::size_t>());
    errors = {one.at("calls"), one.at("original_error"), one.at("error")};
    if (one.contains("failed_error")) {
      errors.failed_generated = number_of(one["failed_error"]);
      errors.failed_original = number_of(one.at("failed_original_error"));
    }
  }
  return exact;
}

// Adds the results for each output.
void add_outputs(Json &json, Graph const &graph, program::Verification const &verification) {
  std::vector<std::string> const names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i) {
    Object const &object = graph.outputs[i];
    for (std::uint32_t element = 0; element < object.count; ++element) {
      std::size_t const slot = object.first + element;
      OutputComparison const &output = verification.outputs[slot];
      Json one = {{"label", object.label},
                  {"element", element},
                  {"name", element_name(names[i], object, element)},
                  {"worst_ulp", output.worst_ulp},
                  {"different", output.different}};
      add_worst(one, output);
      if (!verification.own_flags_ulp.empty()) one["own_flags_ulp"] = verification.own_flags_ulp[slot];
      if (!verification.own_code_ulp.empty()) one["own_code_ulp"] = verification.own_code_ulp[slot];
      json.push_back(std::move(one));
    }
  }
}

void add_guards(Json &json, program::Verification const &verification) {
  if (verification.guards.empty()) return;
  json["refused"] = verification.refused;
  json["guards_different"] = verification.guards_different;
  if (verification.guard_mismatch)
    json["guard_mismatch"] = {{"sample", verification.guard_mismatch->sample},
                              {"expected", verification.guard_mismatch->expected},
                              {"found", verification.guard_mismatch->found}};
  std::size_t evaluated = verification.inside + verification.refused; // a guard is evaluated if those before it hold
  for (program::GuardCheck const &guard : verification.guards) {
    json["guards"].push_back({{"text", guard.text}, {"evaluated", evaluated}, {"failed", guard.failed}});
    evaluated -= std::min(guard.failed, evaluated);
  }
}

void read_guards(Json const &json, program::Verification &verification) {
  if (!json.contains("guards")) return;
  verification.refused = json.at("refused");
  verification.guards_different = json.at("guards_different");
  if (json.contains("guard_mismatch")) {
    Json const &mismatch = json["guard_mismatch"];
    verification.guard_mismatch = {mismatch.at("sample"), mismatch.at("expected"), mismatch.at("found")};
  }
  for (Json const &guard : json["guards"]) verification.guards.push_back({guard.at("text"), guard.at("failed")});
}

Json decisions_json(std::vector<program::DecisionCoverage> const &decisions) {
  Json json = Json::array();
  for (program::DecisionCoverage const &decision : decisions)
    json.push_back({{"place", decision.place},
                    {"of", decision.is_guards ? "guard" : "select"},
                    {"yes", decision.counts.yes},
                    {"no", decision.counts.no}});
  return json;
}

Json branches_json(program::BranchResult const &result) {
  if (!result.obstacle.empty()) return {{"obstacle", result.obstacle}};
  std::size_t const directions = 2 * result.branches.size();
  Json json = {{"directions", directions},
               {"taken", directions - program::count_unseen(result.branches)},
               {"counts", Json::array()}};
  for (program::BranchCount const &branch : result.branches) {
    Json one = {{"place", branch.place}, {"condition", branch.condition}};
    if (!branch.function.empty()) one["function"] = branch.function;
    one["true"] = branch.yes;
    one["false"] = branch.no;
    json["counts"].push_back(std::move(one));
  }
  return json;
}

program::BranchResult branches_of(Json const &json) {
  program::BranchResult result;
  result.obstacle = json.value("obstacle", "");
  for (Json const &one : json.value("counts", Json::array()))
    result.branches.push_back({one.at("place"), one.at("condition"), one.value("function", ""),
                               one.at("true").get<std::uint64_t>(), one.at("false").get<std::uint64_t>()});
  return result;
}

Json to_json(program::ThreadResult const &result) {
  Json json = {{"threads", result.threads}, {"different", result.different}};
  if (result.times)
    json["nanoseconds"] = {{"alone", result.times->alone},
                           {"together", result.times->together},
                           {"times_as_fast", {result.times->low, result.times->gain, result.times->high}}};
  return json;
}

Json to_json(program::ErrorResult const &result) {
  Json json = {{"bits", result.bits}};
  if (!result.obstacle.empty()) json["obstacle"] = result.obstacle;
  json.update({{"samples", result.samples},
               {"untold", result.untold},
               {"left_out", result.left_out},
               {"outputs", Json::array()}});
  for (program::ErrorsOfOutput const &output : result.outputs)
    json["outputs"].push_back({{"original", output.original},
                               {"generated", output.generated},
                               {"original_nearer", output.original_nearer},
                               {"generated_nearer", output.generated_nearer},
                               {"sample", output.worst_sample}});
  return json;
}

// Reads the result. Throws what nlohmann::json throws for a member that is missing or of another type.
program::ErrorResult errors_of(Json const &json, std::size_t outputs) {
  program::ErrorResult result{.bits = json.at("bits"),
                              .obstacle = json.value("obstacle", ""),
                              .samples = json.at("samples"),
                              .untold = json.at("untold"),
                              .left_out = json.at("left_out"),
                              .outputs = {}};
  for (Json const &one : json.at("outputs"))
    result.outputs.push_back({one.at("original"), one.at("generated"), one.at("original_nearer"),
                              one.at("generated_nearer"), one.at("sample")});
  if (result.outputs.size() != outputs) throw std::invalid_argument("outputs without objects");
  return result;
}

} // namespace

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

double number_of(Json const &json) {
  if (!json.is_string()) return json.get<double>();
  std::optional<double> const value = parse_number(json.get<std::string>());
  if (!value) throw std::invalid_argument("no number");
  return *value;
}

Json numbers_json(std::vector<double> const &values) {
  Json json = Json::array();
  for (double value : values) json.push_back(number_json(value));
  return json;
}

std::vector<double> numbers_of(Json const &json) {
  std::vector<double> values;
  for (Json const &one : json) values.push_back(number_of(one));
  return values;
}

VerificationRecord record_of(Json const &json) {
  VerificationRecord record;
  record.graph.kernel = json.at("kernel");
  record.graph.outputs = objects_of(json.at("objects"));
  record.file = json.at("file");
  program::VerificationOptions &options = record.options;
  options.samples = json.at("drawn");
  options.min_samples = json.at("min_samples");
  options.seed = json.at("seed");
  options.tolerance = json.at("tolerance");
  options.shard = {0, json.at("shards").at("count")};
  for (std::size_t number : json["shards"].at("done")) record.shards.push_back(number - 1);
  program::Verification &verification = record.verification;
  std::optional<FloatingPoint> const mode = parse_floating_point(json.at("mode").get<std::string>());
  if (!mode) throw std::invalid_argument("no mode");
  verification.mode = *mode;
  verification.tolerance = options.tolerance;
  verification.mathematics = json.value("mathematics", "");
  verification.tried = json.at("samples");
  verification.inside = json.at("inside");
  verification.not_finite = json.at("not_finite");
  verification.zero_sign = json.at("zero_sign");
  verification.undefined = json.at("undefined");
  verification.outside_different = json.at("outside_different");
  verification.graph_different = json.at("graph_different");
  verification.around = json.at("around");
  verification.crossed = json.at("crossed");
  std::size_t const count = record.graph.output_count();
  for (Json const &one : json.at("outputs")) {
    read_comparison(one, verification.outputs.emplace_back());
    if (one.contains("own_flags_ulp")) verification.own_flags_ulp.push_back(one["own_flags_ulp"]);
    if (one.contains("own_code_ulp")) verification.own_code_ulp.push_back(one["own_code_ulp"]);
  }
  if (verification.outputs.size() != count) throw std::invalid_argument("outputs without objects");
  verification.lost.resize(count);
  if (json.contains("real")) {
    verification.is_single = true;
    verification.decided_otherwise = json.at("decided_otherwise");
    verification.lost = json.at("lost").get<std::vector<std::size_t>>();
  }
  verification.rewritten = comparisons_of(json.at("rewritten"), count);
  verification.called_again = comparisons_of(json.at("called_again"), count);
  verification.called_beyond = comparisons_of(json.value("called_beyond", Json::array()), count);
  if (json.contains("wrapped")) verification.wrapped = comparisons_of(json["wrapped"], count);
  if (json.contains("parallel"))
    verification.threads = program::ThreadResult{json["parallel"].at("threads"), json["parallel"].at("different")};
  verification.has_values = json.value("has_values", true);
  if (json.contains("derivatives")) verification.derivatives = derivatives_of(json["derivatives"], count);
  verification.exact = exact_of(json.value("extended", Json()), record.graph);
  read_guards(json, verification);
  for (Json const &one : json.at("decisions"))
    verification.decisions.push_back({one.at("place"),
                                      one.at("of") == "guard",
                                      {one.at("yes").get<std::size_t>(), one.at("no").get<std::size_t>()}});
  if (json.contains("branches")) verification.branches = branches_of(json["branches"]);
  if (json.contains("errors")) verification.errors = errors_of(json["errors"], count);
  verification.left = left_of(json.at("left_behind"));
  verification.left_by_wrapper = left_of(json.at("left_by_wrapper"));
  verification.unnamed = left_of(json.value("unnamed", Json::array()));
  verification.overwritten = left_of(json.value("overwritten", Json::array()));
  verification.unexamined = json.value("unexamined", "");
  verification.changes_outside = left_of(json.value("changes_outside", Json::array()));
  verification.next_call_different = json.value("next_call_different", std::size_t{0});
  verification.outside = left_of(json.value("outside", Json::array()));
  if (json.contains("missed_by_wrapper")) verification.missed_by_wrapper = left_of(json["missed_by_wrapper"]);
  for (Json const &one : json.at("named"))
    verification.named[one.at("sample")] = {numbers_of(one.at("inputs")), numbers_of(one.at("parameters"))};
  return record;
}

Json to_json(VerificationRecord const &record) {
  program::Verification const &verification = record.verification;
  Json json = {{"kernel", record.graph.kernel},
               {"file", record.file},
               {"mode", to_string(verification.mode)},
               {"mathematics", verification.mathematics},
               {"tolerance", verification.tolerance},
               {"drawn", record.options.samples},
               {"min_samples", record.options.min_samples},
               {"seed", record.options.seed},
               {"shards", {{"count", record.options.shard.count}, {"done", Json::array()}}},
               {"samples", verification.tried},
               {"inside", verification.inside},
               {"not_finite", verification.not_finite},
               {"zero_sign", verification.zero_sign},
               {"undefined", verification.undefined},
               {"outside_different", verification.outside_different},
               {"graph_different", verification.graph_different},
               {"around", verification.around},
               {"crossed", verification.crossed},
               {"objects", Json::array()},
               {"outputs", Json::array()}};
  for (std::size_t shard : record.shards) json["shards"]["done"].push_back(shard + 1);
  for (Object const &object : record.graph.outputs) json["objects"].push_back(object_json(object));
  add_outputs(json["outputs"], record.graph, verification);
  if (verification.is_single) {
    json["real"] = "float";
    json["decided_otherwise"] = verification.decided_otherwise;
    json["lost"] = verification.lost;
  }
  if (verification.derivatives) json["derivatives"] = to_json(*verification.derivatives);
  if (!verification.has_values) json["has_values"] = false;
  if (verification.threads) json["parallel"] = to_json(*verification.threads);
  if (verification.exact.calls != 0) json["extended"] = exact_json(record.graph, verification.exact);
  json["rewritten_different"] = program::count_different(verification.rewritten);
  json["called_again_different"] = program::count_different(verification.called_again);
  json["rewritten"] = comparisons_json(verification.rewritten);
  json["called_again"] = comparisons_json(verification.called_again);
  if (program::count_different(verification.called_beyond) != 0)
    json["called_beyond"] = comparisons_json(verification.called_beyond);
  if (!verification.wrapped.empty()) json["wrapped"] = comparisons_json(verification.wrapped);
  json["left_behind"] = left_json(verification.left);
  json["left_by_wrapper"] = left_json(verification.left_by_wrapper);
  if (!verification.unnamed.empty()) json["unnamed"] = left_json(verification.unnamed);
  if (!verification.overwritten.empty()) json["overwritten"] = left_json(verification.overwritten);
  if (!verification.unexamined.empty()) json["unexamined"] = verification.unexamined;
  if (!verification.changes_outside.empty()) json["changes_outside"] = left_json(verification.changes_outside);
  if (verification.next_call_different != 0) json["next_call_different"] = verification.next_call_different;
  if (!verification.outside.empty()) json["outside"] = left_json(verification.outside);
  if (!verification.missed_by_wrapper.empty()) json["missed_by_wrapper"] = left_json(verification.missed_by_wrapper);
  add_guards(json, verification);
  json["decisions"] = decisions_json(verification.decisions);
  if (verification.branches) json["branches"] = branches_json(*verification.branches);
  if (verification.errors) json["errors"] = to_json(*verification.errors);
  json["named"] = Json::array();
  for (auto const &[number, sample] : verification.named)
    json["named"].push_back(
        {{"sample", number}, {"inputs", numbers_json(sample.inputs)}, {"parameters", numbers_json(sample.parameters)}});
  return json;
}

} // namespace symreal::tool
