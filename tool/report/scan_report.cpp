#include "tool/report/scan_report.h"

#include "engine/support/installation.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ostream.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;
using rewrite::Fate;

// Counts of the word `double`, by fate.
struct Tally {
  std::array<std::size_t, 5> counts{}; // by Fate
  std::size_t floats = 0, long_doubles = 0;

  std::size_t operator[](Fate fate) const { return counts[static_cast<std::size_t>(fate)]; }
  std::size_t converted() const { return (*this)[Fate::converted] + (*this)[Fate::follows]; }
  std::size_t compiled() const { return converted() + (*this)[Fate::passive] + (*this)[Fate::diagnosed]; }
  std::size_t all() const { return compiled() + (*this)[Fate::inactive]; }
  Tally &operator+=(Tally const &other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    floats += other.floats;
    long_doubles += other.long_doubles;
    return *this;
  }
};

Tally tally(std::vector<rewrite::Spelling> const &ledger) {
  Tally result;
  for (rewrite::Spelling const &one : ledger)
    if (one.type == "float")
      ++result.floats;
    else if (one.type == "long double")
      ++result.long_doubles;
    else
      ++result.counts[static_cast<std::size_t>(one.fate)];
  return result;
}

// Equal entries, with the place of the first.
struct Group {
  std::size_t count = 0;
  Place first;
  std::string words; // text of the first
  void add(Place const &place, std::string const &said = {}) {
    if (count++ != 0) return;
    first = place;
    words = said;
  }
};

std::string percent(Tally const &tally) {
  if (tally.compiled() == 0) return "-";
  // Rounds down: 100% means all of them.
  return std::to_string(tally.converted() * 100 / tally.compiled()) + "%";
}

void print_row(std::ostream &out, std::size_t width, std::string const &name, Tally const &tally) {
  fmt::print(out, "  {:<{}}{:>8}{:>11}{:>9}{:>11}{:>10}{:>7}\n", name, width, tally.all(), tally.converted(),
             tally[Fate::passive], tally[Fate::diagnosed], tally[Fate::inactive], percent(tally));
}

void print_files(std::ostream &out, rewrite::Result const &result) {
  std::size_t width = 10;
  for (rewrite::File const &file : result.files) width = std::max(width, file.display_path.size());
  fmt::print(out, "  {:<{}}{:>8}{:>11}{:>9}{:>11}{:>10}{:>7}\n", "file", width, "double", "converted", "passive",
             "diagnosed", "inactive", "share");
  Tally total;
  for (rewrite::File const &file : result.files) {
    Tally const one = tally(file.ledger);
    if (one.all() != 0) print_row(out, width, file.display_path, one);
    total += one;
  }
  print_row(out, width, "total", total);
  if (total.floats + total.long_doubles != 0)
    fmt::print(out, "left as they are: {} float, {} long double\n", total.floats, total.long_doubles);
}

std::string reason(rewrite::Spelling const &spelling) {
  return spelling.reason + (spelling.detail.empty() ? "" : ": " + spelling.detail);
}

void print_reasons(std::ostream &out, rewrite::Result const &result, Fate fate, char const *title) {
  std::map<std::string, Group> groups;
  for (rewrite::File const &file : result.files)
    for (rewrite::Spelling const &one : file.ledger)
      if (one.fate == fate && one.type == "double") groups[reason(one)].add(one.place);
  if (!groups.empty()) out << title << "\n";
  for (auto const &[words, group] : groups)
    fmt::print(out, "  {:>6}  {}; first at {}\n", group.count, words, to_string(group.first));
}

void print_obstacles(std::ostream &out, rewrite::Result const &result) {
  std::map<DiagnosticId, Group> groups;
  for (Diagnostic const &one : result.diagnostics) groups[one.id].add(one.place);
  out << (groups.empty() ? "obstacles: none\n" : "obstacles\n");
  for (auto const &[id, group] : groups)
    fmt::print(out, "  {:>6}  {} {}; first at {}\n", group.count, code(id), info(id).summary, to_string(group.first));
}

void print_dependence(std::ostream &out, rewrite::Result const &result) {
  std::size_t const selectable = static_cast<std::size_t>(std::count_if(
      result.decisions.begin(), result.decisions.end(), [](rewrite::Decision const &one) { return one.selectable; }));
  fmt::print(out, "decisions on REAL: {}, of which {} can be a select\n", result.decisions.size(), selectable);
  std::map<std::string, Group> refused;
  for (rewrite::Decision const &one : result.decisions)
    if (std::string const begin = one.kind + ", because of "; !one.selectable)
      refused[begin + kind(one.reason)].add(one.place, begin + words(one.reason));
  std::vector<std::pair<std::string, Group>> sorted(refused.begin(), refused.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](auto const &left, auto const &right) { return left.second.count > right.second.count; });
  for (auto const &[kind, group] : sorted)
    fmt::print(out, "  {:>6}  {}; first at {}\n", group.count, group.count == 1 ? group.words : kind,
               to_string(group.first));
  auto const integers = std::count_if(result.conversions.begin(), result.conversions.end(),
                                      [](rewrite::Conversion const &one) { return one.to_integer; });
  fmt::print(out, "comparisons of REAL: {}; conversions of REAL: {} to an integer, {} to float or long double\n",
             result.comparisons, integers, static_cast<std::ptrdiff_t>(result.conversions.size()) - integers);
}

void print_places(std::ostream &out, rewrite::Result const &result) {
  static constexpr std::array<char const *, 5> fates = {"inactive", "converted", "passive", "diagnosed", "converted"};
  out << "what stays\n";
  for (rewrite::File const &file : result.files)
    for (rewrite::Spelling const &one : file.ledger)
      if (one.fate != Fate::converted)
        fmt::print(out, "  {}: {} is {}: {}\n", to_string(one.place), one.type,
                   fates[static_cast<std::size_t>(one.fate)], reason(one));
  out << "what depends on values\n";
  for (rewrite::Decision const &one : result.decisions)
    fmt::print(out, "  {}: {} {}\n", to_string(one.place), one.kind,
               one.selectable ? "can be a select"
                              : "cannot be a select because of " + words(one.reason) + " at " + to_string(one.token));
  for (rewrite::Conversion const &one : result.conversions)
    fmt::print(out, "  {}: a REAL is converted to {}\n", to_string(one.place), one.type);
  out << "what blocks it\n";
  for (Diagnostic const &one : result.diagnostics)
    fmt::print(out, "  {}: {} [{}]\n", to_string(one.place), one.message, code(one.id));
}

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
  static constexpr std::array<char const *, 5> fates = {"inactive", "converted as neighbours", "passive", "diagnosed",
                                                        "converted"};
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

class Within {
public:
  explicit Within(rewrite::Reach const &reach) : reach_(reach) {}

  bool operator()(Place const &place) const {
    return std::any_of(reach_.functions.begin(), reach_.functions.end(), [&](rewrite::ReachedFunction const &one) {
      return one.begin.file == place.file && one.begin.line <= place.line && place.line <= one.end.line;
    });
  }

private:
  rewrite::Reach const &reach_;
};

std::string use(rewrite::ReachedState const &state) {
  if (state.is_written) return "written";
  return state.is_passed_on ? "its address is passed on" : "read";
}

void print_state(std::ostream &out, rewrite::Reach const &reach) {
  if (reach.state.empty()) return;
  out << "  state that outlives a call\n";
  std::set<std::string> changed;
  for (rewrite::ReachedState const &one : reach.state) {
    fmt::print(out, "    {}: {}, {}\n", to_string(one.place), one.name, use(one));
    if (one.is_written || one.is_passed_on) changed.insert(one.name);
  }
  std::string list;
  for (std::string const &name : changed) list += (list.empty() ? "" : ", ") + name;
  if (!list.empty())
    fmt::print(out, "    where the values that a call leaves in them are not read: scratch({})\n", list);
}

} // namespace

void print_readiness(std::ostream &out, rewrite::Request const &request, rewrite::Result const &result, bool list) {
  fmt::print(out, "{} sources, {} files within the roots\n", request.sources.size(), result.files.size());
  for (std::string const &source : result.left_out) fmt::print(out, "left out, does not compile: {}\n", source);
  print_files(out, result);
  print_reasons(out, result, Fate::passive, "passive");
  print_reasons(out, result, Fate::inactive, "inactive");
  print_obstacles(out, result);
  print_dependence(out, result);
  if (list) print_places(out, result);
}

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

void print_reach(std::ostream &out, std::string const &function, rewrite::Reach const &reach,
                 rewrite::Result const &result) {
  Within const within(reach);
  std::set<std::string> files;
  for (rewrite::ReachedFunction const &one : reach.functions) files.insert(one.begin.file);
  fmt::print(out, "{} reaches {} functions in {} files\n", function, reach.functions.size(), files.size());
  print_state(out, reach);
  std::string title;
  auto const line = [&](char const *of, std::string const &text) {
    if (title != of) fmt::print(out, "  {}\n", of);
    title = of;
    fmt::print(out, "    {}\n", text);
  };
  for (rewrite::Decision const &one : result.decisions)
    if (within(one.place))
      line("decisions on values",
           fmt::format("{}: {} {}", to_string(one.place), one.kind,
                       one.selectable ? "can be a select" : "cannot be a select because of " + words(one.reason)));
  for (rewrite::Conversion const &one : result.conversions)
    if (within(one.place)) line("conversions of values", to_string(one.place) + ": to " + one.type);
  for (Diagnostic const &one : result.diagnostics)
    if (within(one.place))
      line("what blocks it", fmt::format("{}: {} [{}]", to_string(one.place), one.message, code(one.id)));
  for (Note const &one : reach.not_followed) line("not followed", to_string(one.place) + ": " + one.message);
  for (std::string const &one : reach.undefined) line("called, but not defined in the given sources", one);
}

} // namespace symreal::tool
