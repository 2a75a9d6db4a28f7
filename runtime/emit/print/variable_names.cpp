#include "emit/print/variable_names.h"

#include "emit/print/angles.h"

#include "graph/names.h"
#include "support/number.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace symreal {

// Variables without a name, and the arrays of calls: t1, r1, s1, a1_2.
static bool is_numbered(std::string const &name) {
  auto const is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return name.size() > 1 && std::string_view("arst").find(name[0]) != std::string_view::npos && is_digit(name[1]) &&
         std::all_of(name.begin() + 2, name.end(), [&](char c) { return c == '_' || is_digit(c); });
}

static std::vector<std::string> words_in(std::string const &text) {
  std::vector<std::string> words(1);
  for (char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  return words;
}

// Names of the generated functions' own, besides keywords: arrays, the status, the operations, and words that some
// compilers predefine.
static std::set<std::string> own_names(Emission const &emission) {
  std::set<std::string> names = {"input", "output", "constants", "parameters", "v", "failed", "unix", "linux", "i386"};
  if (emission.plan.angles.size() != 0)
    names.insert({"sine", "cosine", "angle", "sines_and_cosines", "sines_and_cosines_within", computed_angles});
  names.insert(emission.local_names.begin(), emission.local_names.end());
  for (OperationInfo const &operation : operations()) {
    names.emplace(operation.c);
    for (Spellings::Piece const &piece : emission.spellings[operation.op].pieces)
      for (std::string const &word : words_in(piece.text)) names.insert(word);
  }
  return names;
}

// Between a name and what makes it another.
static char joint(NameRules const &rules) { return rules.has_underscores ? '_' : '$'; }

VariableNames::VariableNames(Emission const &emission, FunctionBody const &body)
    : rules_(&emission.language.names),
      written_(emission.language.expressions.variable) {
  Graph const &graph = emission.graph();
  if (graph.node_name.empty()) return;
  NameRules const &rules = emission.language.names;
  char const mark = joint(rules);
  std::set<std::string> all, own, given;
  for (std::string const &name : graph.names) all.insert(rules.key(name));
  for (std::string const &name : own_names(emission)) own.insert(rules.key(name));
  for (External const &external : graph.externals) own.insert(rules.key(external.name));
  for (std::string const &name : emission.bridges) own.insert(rules.key(name));
  for (std::string const &name : graph.names) {
    std::string base = name;
    // C reserves what begins with an underscore; other letters than ASCII's are not C99.
    for (char &c : base)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    if (base[0] == '_') base = "u" + base;
    base = rules.spelled(base);
    std::string const key = rules.key(base);
    bool const is_taken = is_numbered(key) || key.starts_with(rules.spelled("table_")) || rules.is_keyword(key) ||
                          own.contains(key) || !given.insert(key).second;
    if (is_taken || (base != name && all.contains(key))) base += mark;
    while (base != name && !all.insert(rules.key(base)).second) base += mark;
    bases_.push_back(base);
  }
  std::vector<std::uint32_t> next(bases_.size(), 1);
  for (NodeId id : body.variables) {
    NameId const name = body.regions.is_gate(id) ? no_name : graph.node_name[id];
    entries_.push_back({name, 0});
    if (name == no_name) continue;
    std::uint32_t number = next[name];
    while (number > 1 && all.contains(rules.key(bases_[name] + mark + std::to_string(number)))) ++number;
    entries_.back().number = number;
    next[name] = number + 1;
  }
}

void VariableNames::append_to(std::string &text, std::size_t variable) const {
  if (!written_) return append_name(text, variable);
  std::string name;
  append_name(name, variable);
  text += written_(name);
}

std::string VariableNames::operator()(std::size_t variable) const {
  std::string text;
  append_to(text, variable);
  return text;
}

void VariableNames::append_name(std::string &text, std::size_t variable) const {
  if (entries_.empty() || entries_[variable].name == no_name) {
    text += 't';
    return append_number(text, variable);
  }
  Entry const &entry = entries_[variable];
  text += bases_[entry.name];
  if (entry.number == 1) return;
  text += joint(*rules_);
  append_number(text, entry.number);
}

} // namespace symreal
