#include "tool/report/readiness.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ostream.h>

namespace symreal::tool {
namespace {

using rewrite::Fate;

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
  static constexpr std::array<char const *, 5> fates = {"converted", "converted", "passive", "diagnosed", "inactive"};
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

} // namespace

Tally &Tally::operator+=(Tally const &other) {
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
  floats += other.floats;
  long_doubles += other.long_doubles;
  return *this;
}

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

} // namespace symreal::tool
