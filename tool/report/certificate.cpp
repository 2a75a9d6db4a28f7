#include "tool/report/certificate.h"

#include "graph/graph_text.h"
#include "program/durable_files.h"
#include "support/files.h"
#include "support/math_library.h"
#include "support/version.h"

#include <fmt/format.h>
#include <sstream>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr int form = 1; // of certificates

std::string text_hash(Graph const &graph) {
  std::ostringstream text;
  write_graph(text, graph);
  return program::content_hash(text.str());
}

std::string digest_of(Json json) {
  json.erase("digest");
  return program::content_hash(json.dump());
}

// What the same run gives again: no times.
Json repeatable(Json json) {
  for (Json &record : json["verified"])
    if (record.contains("parallel")) record["parallel"].erase("nanoseconds");
  return json;
}

void compare_hashes(Json const &one, Json const &other, std::string_view what, std::vector<std::string> &found) {
  for (auto const &[name, hash] : one.items())
    if (!other.contains(name))
      found.push_back(fmt::format("{} '{}' is not there now", what, name));
    else if (other[name] != hash)
      found.push_back(fmt::format("{} '{}' is another one now", what, name));
  for (auto const &[name, hash] : other.items())
    if (!one.contains(name)) found.push_back(fmt::format("{} '{}' is new", what, name));
}

// The first member that differs, as a path.
std::string first_difference(Json const &one, Json const &other, std::string const &path) {
  if (one == other) return {};
  if (one.is_object() && other.is_object())
    for (auto const &[name, value] : one.items())
      if (std::string found = first_difference(value, other.value(name, Json()), path + "/" + name); !found.empty())
        return found;
  if (one.is_array() && other.is_array() && one.size() == other.size())
    for (std::size_t k = 0; k < one.size(); ++k)
      if (std::string found = first_difference(one[k], other[k], path + "/" + std::to_string(k)); !found.empty())
        return found;
  return fmt::format("{}: {} in the certificate, {} now", path, one.dump(), other.dump());
}

} // namespace

Json certificate(Verified const &verified, std::vector<VerificationRecord> const &records) {
  Json json = {
      {"symreal_certificate", form}, {"version", version}, {"flags", verified.flags}, {"mathematics", math_library()}};
  for (char const *hashed : {"sources", "generated", "graphs"}) json[hashed] = Json::object();
  for (rewrite::File const &file : verified.front->rewritten.files)
    json["sources"][file.display_path] = program::content_hash(file.original);
  for (std::string const &file : verified.generated) json["generated"][file] = program::file_hash(file);
  for (program::Recorded const &recorded : verified.front->kernels)
    json["graphs"][recorded.graph.kernel] = text_hash(recorded.graph);
  json["verified"] = Json::array();
  for (VerificationRecord const &record : records) json["verified"].push_back(to_json(record));
  json["digest"] = digest_of(json);
  return json;
}

Json read_certificate(std::string const &path) {
  Json json = Json::parse(read_file(path), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || json.value("symreal_certificate", 0) != form || !json.contains("digest"))
    fail(DiagnosticId::verification_file, {path}, "this file is no certificate that verify --certificate wrote");
  if (json["digest"] != digest_of(json))
    fail(DiagnosticId::certificate_refused, {path}, "the certificate was changed after it was written");
  if (json.value("version", "") != version)
    fail(DiagnosticId::certificate_refused, {path},
         fmt::format("the certificate was written by version {}, and this is version {}", json.value("version", ""),
                     version));
  return json;
}

program::VerificationOptions options_of(Json const &certificate, std::string const &path) {
  try {
    Json const &record = certificate.at("verified").at(0);
    program::VerificationOptions options;
    options.samples = record.at("drawn");
    options.min_samples = record.at("min_samples");
    options.seed = record.at("seed");
    options.tolerance = record.at("tolerance");
    options.branches = record.contains("branches");
    if (record.contains("errors")) options.exact_bits = record["errors"].at("bits");
    return options;
  } catch (Json::exception const &) {
    fail(DiagnosticId::verification_file, {path}, "this file is no certificate that verify --certificate wrote");
  }
}

std::vector<std::string> differences(Json const &certificate, Json const &run) {
  std::vector<std::string> found;
  compare_hashes(certificate["sources"], run["sources"], "source", found);
  compare_hashes(certificate["generated"], run["generated"], "generated file", found);
  compare_hashes(certificate["graphs"], run["graphs"], "the recorded graph of kernel", found);
  if (certificate["flags"] != run["flags"]) found.push_back("the sources have other compiler flags");
  Json const one = repeatable(certificate)["verified"], other = repeatable(run)["verified"];
  if (std::string const figure = first_difference(one, other, "figure "); !figure.empty()) found.push_back(figure);
  return found;
}

std::string other_mathematics(Json const &certificate, Json const &run) {
  std::string const before = certificate.value("mathematics", ""), now = run.value("mathematics", "");
  if (before.empty() || before == now) return {};
  return fmt::format("the certificate was written with {}; these functions are those of {}", before, now);
}

} // namespace symreal::tool
