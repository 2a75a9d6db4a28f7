#include "tool/report/verification_record.h"

#include "engine/support/files.h"
#include "tool/report/json_fields.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(std::string const &path, std::string const &why) {
  fail(DiagnosticId::verification_file, {path}, why);
}

Json parse_file(std::string const &path) {
  Json json = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) refuse(path, "this file is not what verify --json prints");
  return json;
}

std::size_t derivative_count(program::Verification const &verification) {
  return verification.derivatives ? verification.derivatives->elements.size() : 0;
}

// The first difference in properties that all shards must share; empty if they agree.
std::string difference(VerificationRecord const &one, VerificationRecord const &other) {
  program::Verification const &a = one.verification, &b = other.verification;
  if (one.graph.kernel != other.graph.kernel) return "it is of kernel '" + other.graph.kernel + "'";
  if (one.file != other.file) return "it is of '" + other.file + "'";
  if (a.mode != b.mode || a.is_single != b.is_single || a.tolerance != b.tolerance)
    return "it is of another mode or tolerance";
  if (a.outputs.size() != b.outputs.size() || a.guards.size() != b.guards.size() ||
      a.decisions.size() != b.decisions.size() || a.wrapped.size() != b.wrapped.size() ||
      a.own_flags_ulp.size() != b.own_flags_ulp.size() || a.own_code_ulp.size() != b.own_code_ulp.size() ||
      derivative_count(a) != derivative_count(b))
    return "its kernel has another shape";
  if (a.errors.has_value() != b.errors.has_value() || (a.errors && a.errors->bits != b.errors->bits))
    return "it has other exact values";
  if (one.options.samples != other.options.samples || one.options.seed != other.options.seed)
    return "it has other samples or another seed";
  if (one.options.shard.count != other.options.shard.count)
    return fmt::format("it is a shard of {}, and not of {}", other.options.shard.count, one.options.shard.count);
  return {};
}

} // namespace

VerificationRecord record_of(Graph const &graph, std::string const &file, program::Verification verification,
                             program::VerificationOptions const &options) {
  VerificationRecord record{{}, file, std::move(verification), options, {options.shard.index}};
  record.graph.kernel = graph.kernel;
  record.graph.outputs = graph.outputs;
  record.options.replayed.clear();
  return record;
}

std::vector<VerificationRecord> read_records(std::string const &path) {
  Json const json = parse_file(path);
  std::vector<VerificationRecord> records;
  try {
    for (Json const &one : json.contains("kernels") ? json["kernels"] : Json::array({json}))
      records.push_back(record_of(one));
  } catch (std::exception const &) {
    refuse(path, "this file is not what verify --json prints");
  }
  return records;
}

std::vector<Sample> read_samples(std::string const &path, Graph const &graph) {
  Json const json = parse_file(path);
  std::vector<Sample> samples;
  try {
    for (Json const &one : json.contains("kernels") ? json["kernels"] : Json::array({json})) {
      if (one.contains("kernel") && one["kernel"] != graph.kernel) continue;
      for (Json const &named : one.contains("named") ? one["named"] : Json::array({one}))
        samples.push_back({numbers_of(named.at("inputs")), numbers_of(named.value("parameters", Json::array()))});
    }
  } catch (std::exception const &) {
    refuse(path, "this file has no samples: it is neither what verify --json prints nor {\"inputs\": [...]}");
  }
  for (Sample const &sample : samples)
    if (sample.inputs.size() != graph.input_count() || sample.parameters.size() != graph.parameter_count())
      refuse(path, "kernel '" + graph.kernel + "' has " + std::to_string(graph.input_count()) + " inputs and " +
                       std::to_string(graph.parameter_count()) + " parameters, a sample in this file has " +
                       std::to_string(sample.inputs.size()) + " and " + std::to_string(sample.parameters.size()));
  if (samples.empty())
    refuse(path, "this file has no samples of kernel '" + graph.kernel + "': all outputs are equal in it");
  return samples;
}

void join(VerificationRecord &record, VerificationRecord const &other, std::string const &path) {
  if (std::string const text = difference(record, other); !text.empty())
    refuse(path, "this file cannot be joined with those before it: " + text);
  for (std::size_t shard : other.shards) {
    if (std::ranges::find(record.shards, shard) != record.shards.end())
      refuse(path, fmt::format("this file cannot be joined with those before it: both are of shard {}", shard + 1));
    record.shards.push_back(shard);
  }
  std::ranges::sort(record.shards);
  program::join(record.verification, other.verification);
}

} // namespace symreal::tool
