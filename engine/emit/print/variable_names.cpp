#include "engine/emit/print/variable_names.h"

#include "engine/emit/print/angles.h"

#include "engine/graph/names.h"
#include "engine/support/number.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace symreal {

// Whether the name has the form of unnamed variables and arrays of calls: t1, r1, s1, a1_2.
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

// Object-like macros of <math.h>, <stdint.h> and of the generated file.
static bool is_macro(std::string_view name) {
  static constexpr std::string_view macros[] = {
      "NAN",    "INFINITY", "HUGE_VAL", "HUGE_VALF", "HUGE_VALL", "M_E",    "M_LOG2E",         "M_LOG10E", "M_LN2",
      "M_LN10", "M_PI",     "M_PI_2",   "M_PI_4",    "M_1_PI",    "M_2_PI", "M_2_SQRTPI",      "M_SQRT2",  "M_SQRT1_2",
      "DOMAIN", "SING",     "OVERFLOW", "UNDERFLOW", "PLOSS",     "TLOSS",  "math_errhandling"};
  static constexpr std::string_view beginnings[] = {"FP_",     "MATH_",   "SYMREAL_", "INT_",     "INT8_",   "INT16_",
                                                    "INT32_",  "INT64_",  "INTPTR_",  "INTMAX_",  "UINT_",   "UINT8_",
                                                    "UINT16_", "UINT32_", "UINT64_",  "UINTPTR_", "UINTMAX_"};
  return std::ranges::find(macros, name) != std::end(macros) ||
         std::ranges::any_of(beginnings, [&](std::string_view beginning) { return name.starts_with(beginning); });
}

// Functions and types of the generated file whose names end in a number.
static bool is_of_file(Emission const &emission, std::string_view name) {
  for (std::string const &beginning : {emission.name("compute"), emission.name("preprocess"), std::string("load"),
                                       std::string("store"), std::string(emission.language.number.name)}) {
    std::string_view const number = name.substr(std::min(name.size(), beginning.size() + 1));
    if (name.starts_with(beginning + "_") && number.find_first_not_of("0123456789") == number.npos) return true;
  }
  return false;
}

// Reserved names of the generated functions, besides keywords: arrays, the status, the operations, and words that some
// compilers predefine.
static std::set<std::string> own_names(Emission const &emission) {
  std::set<std::string> names = {"input",        "output",       "constants",    "parameters", "v",
                                 "failed",       "unix",         "linux",        "i386",       "at_run",
                                 "kept_integer", "keep_integer", "report_value", "all_finite"};
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

// Separator between a name and its number.
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
    // C reserves names with a leading underscore; C99 has ASCII letters only.
    for (char &c : base)
      if (static_cast<unsigned char>(c) >= 0x80 || !std::isalnum(static_cast<unsigned char>(c))) c = '_';
    if (base.empty() || !std::isalpha(static_cast<unsigned char>(base[0]))) base = "u" + base;
    base = rules.spelled(base);
    std::string const key = rules.key(base);
    bool const is_taken = is_numbered(key) || is_macro(base) || is_of_file(emission, base) ||
                          key.starts_with(rules.spelled("table_")) || rules.is_keyword(key) || own.contains(key) ||
                          !given.insert(key).second;
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
