#include "tool/report/readiness.h"

#include "engine/support/version.h"

#include <nlohmann/json.hpp>
#include <set>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;
using rewrite::Fate;

Json to_json(Place const &place) { return {{"file", place.file}, {"line", place.line}, {"column", place.column}}; }

Json to_json(Tally const &tally) {
  return {{"doubles", tally.all()},
          {"converted", tally.converted()},
          {"converted_as_neighbours", tally[Fate::follows]},
          {"passive", tally[Fate::passive]},
          {"diagnosed", tally[Fate::diagnosed]},
          {"inactive", tally[Fate::inactive]},
          {"floats", tally.floats},
          {"long_doubles", tally.long_doubles}};
}

Json to_json(rewrite::Spelling const &spelling) {
  static constexpr std::array<char const *, 5> fates = {"converted", "converted as neighbours", "passive", "diagnosed",
                                                        "inactive"};
  Json json = {{"line", spelling.place.line},
               {"column", spelling.place.column},
               {"type", spelling.type},
               {"fate", fates[static_cast<std::size_t>(spelling.fate)]}};
  if (!spelling.reason.empty()) json["reason"] = spelling.reason;
  if (!spelling.detail.empty()) json["detail"] = spelling.detail;
  return json;
}

char const *spelling(Severity severity) {
  switch (severity) {
  case Severity::error: return "error";
  case Severity::warning: return "warning";
  case Severity::remark: return "note";
  }
  return "none";
}

std::string uri(std::string const &path) {
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string text = path.starts_with('/') ? "file://" : "";
  for (char c : path)
    if (std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/-._~+").find(c) != std::string_view::npos)
      text += c;
    else {
      text += '%';
      text += digits[static_cast<unsigned char>(c) >> 4];
      text += digits[static_cast<unsigned char>(c) & 15];
    }
  return text;
}

Json location(Place const &place) {
  Json physical = {{"artifactLocation", {{"uri", uri(place.file)}}}};
  if (place.line != 0) physical["region"]["startLine"] = place.line;
  if (place.line != 0 && place.column != 0) physical["region"]["startColumn"] = place.column;
  return {{"physicalLocation", std::move(physical)}};
}

Json finding(DiagnosticId id, char const *level, Place const &place, std::string const &message) {
  Json json = {{"ruleId", code(id)}, {"level", level}, {"message", {{"text", message}}}};
  if (!place.file.empty()) json["locations"] = Json::array({location(place)});
  return json;
}

Json rule(DiagnosticId id) {
  DiagnosticInfo const &row = info(id);
  return {{"id", code(id)},
          {"name", row.name},
          {"shortDescription", {{"text", row.summary}}},
          {"fullDescription", {{"text", row.explanation}}},
          {"help", {{"text", row.help}}}};
}

} // namespace

Json readiness_json(rewrite::Request const &request, rewrite::Result const &result) {
  Json files = Json::array(), obstacles = Json::array(), decisions = Json::array(), conversions = Json::array();
  Tally total;
  for (rewrite::File const &file : result.files) {
    Tally const one = tally(file.ledger);
    total += one;
    Json tokens = Json::array();
    for (rewrite::Spelling const &entry : file.ledger) tokens.push_back(to_json(entry));
    files.push_back({{"file", file.display_path}, {"tally", to_json(one)}, {"tokens", std::move(tokens)}});
  }
  for (Diagnostic const &one : result.diagnostics)
    obstacles.push_back({{"id", code(one.id)},
                         {"severity", spelling(one.severity)},
                         {"place", to_json(one.place)},
                         {"message", one.message}});
  for (rewrite::Decision const &one : result.decisions) {
    Json json = {{"kind", one.kind}, {"place", to_json(one.place)}, {"selectable", one.selectable}};
    if (!one.selectable) json.update({{"reason", words(one.reason)}, {"because_of", to_json(one.token)}});
    decisions.push_back(std::move(json));
  }
  for (rewrite::Conversion const &one : result.conversions)
    conversions.push_back({{"type", one.type}, {"place", to_json(one.place)}});
  return {{"sources", request.sources},        {"left_out", result.left_out},
          {"total", to_json(total)},           {"files", std::move(files)},
          {"obstacles", std::move(obstacles)}, {"decisions", std::move(decisions)},
          {"comparisons", result.comparisons}, {"conversions", std::move(conversions)}};
}

Json sarif(rewrite::Result const &result) {
  Json results = Json::array(), rules = Json::array();
  std::set<DiagnosticId> used;
  auto const add = [&](DiagnosticId id, char const *level, Place const &place, std::string const &message) {
    used.insert(id);
    results.push_back(finding(id, level, place, message));
  };
  for (Diagnostic const &one : result.diagnostics) add(one.id, spelling(one.severity), one.place, one.message);
  for (rewrite::Decision const &one : result.decisions)
    add(DiagnosticId::symbolic_decision, one.selectable ? "note" : "warning", one.place,
        "'" + one.kind + "' decides on a REAL; it " +
            (one.selectable ? "can be a select" : "cannot be a select because of " + words(one.reason)));
  for (rewrite::Conversion const &one : result.conversions)
    add(DiagnosticId::symbolic_decision, "warning", one.place, "a REAL is converted to " + one.type);
  for (DiagnosticId id : used) rules.push_back(rule(id));
  Json driver = {{"name", "Symreal"}, {"version", version}, {"rules", std::move(rules)}};
  Json run = {
      {"tool", {{"driver", std::move(driver)}}}, {"columnKind", "utf16CodeUnits"}, {"results", std::move(results)}};
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({std::move(run)})}};
}

} // namespace symreal::tool
