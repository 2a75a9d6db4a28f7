#include "engine/emit/print/spellings.h"

#include "engine/emit/print/emission.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <set>

namespace symreal {

namespace {

// Parses a pattern such as "merge($y, $z, $x:4)".
std::vector<Spellings::Piece> parse(std::string_view pattern) {
  std::vector<Spellings::Piece> pieces;
  while (!pattern.empty()) {
    std::size_t const dollar = std::min(pattern.find('$'), pattern.size());
    if (dollar != 0) pieces.push_back({std::string(pattern.substr(0, dollar))});
    if (dollar == pattern.size()) break;
    internal_check(dollar + 1 < pattern.size());
    Spellings::Piece piece{{}, pattern[dollar + 1] - 'x'};
    internal_check(piece.operand >= 0 && piece.operand < 3);
    pattern.remove_prefix(dollar + 2);
    if (pattern.starts_with(':')) {
      auto const end = std::from_chars(pattern.data() + 1, pattern.data() + pattern.size(), piece.binding).ptr;
      pattern.remove_prefix(static_cast<std::size_t>(end - pattern.data()));
    }
    pieces.push_back(piece);
  }
  return pieces;
}

// The cast to the language's type of numbers: of "(double)(int8_t)" the first part is replaced.
std::string cast_of(Language const &language, std::string_view cast) {
  constexpr std::string_view to_double = "(double)";
  if (cast.starts_with(to_double)) cast.remove_prefix(to_double.size());
  return fmt::format("({}){}", language.number.name, cast);
}

// Pattern according to the operation table.
std::string usual_pattern(OperationInfo const &operation, Language const &language) {
  static constexpr std::string_view operands = "$x, $y, $z";
  int const precedence = operation.precedence;
  switch (operation.form) {
  case Form::local:
  case Form::call: {
    ExpressionSyntax const &syntax = language.expressions;
    bool const is_call = operation.form == Form::call;
    return fmt::format("{}{}{}{}{}{}", is_call ? syntax.call_prefix : syntax.local_prefix,
                       language.names.spelled(operation.c),
                       is_call && language.is_single ? language.single.call_suffix : "", syntax.call_open,
                       operands.substr(0, 4 * operation.arity - 2), syntax.call_close);
  }
  case Form::prefix: return fmt::format("{}$x:{}", operation.c, binding::prefix_operand);
  case Form::cast: return cast_of(language, operation.c) + "($x)";
  case Form::infix: {
    // Comparisons and logic are parenthesised when mixed: compilers warn, and readers stumble.
    bool const arithmetic = precedence >= binding::additive;
    std::string const blank = precedence > binding::additive ? "" : " ";
    return fmt::format("$x:{}{}{}{}$y:{}", arithmetic ? precedence : binding::additive, blank, operation.c, blank,
                       arithmetic ? precedence + 1 : binding::additive);
  }
  case Form::select: return fmt::format("$x:{0} ? $y:{0} : $z:{0}", binding::conditional_operand);
  case Form::external: break; // printed by separate code
  }
  return {};
}

} // namespace

Spellings::Spellings(Language const &language) {
  for (OperationInfo const &operation : operations()) {
    bool const is_lacking = operation.form == Form::prefix && operation.c == "+" && !language.expressions.has_plus;
    spellings_[static_cast<std::size_t>(operation.op)] =
        is_lacking ? Spelling{parse("($x)")}
                   : Spelling{parse(usual_pattern(operation, language)), operation.precedence};
  }
  for (OperationSpelling const &exception : language.expressions.operations)
    spellings_[static_cast<std::size_t>(exception.op)] = {parse(with_words(language, exception.pattern)),
                                                          exception.precedence};
  if (language.is_single) make_single(language);
}

// In single precision, rounding to float is the identity, and functions that return double get a cast.
void Spellings::make_single(Language const &language) {
  spellings_[static_cast<std::size_t>(Op::f32)] = {parse("($x)"), 0};
  if (language.single.narrowed.empty()) return;
  for (OperationInfo const &operation : operations()) {
    Spelling &spelling = spellings_[static_cast<std::size_t>(operation.op)];
    bool const is_call = operation.form == Form::call || operation.form == Form::local;
    bool const is_given = std::ranges::find(language.single.given, operation.op) != language.single.given.end();
    if (!is_call || is_given || spelling.precedence != 0 || operation.has(flag::BOOLEAN)) continue;
    spelling.pieces.insert(spelling.pieces.begin(), {std::string(language.single.narrowed)});
    spelling.precedence = binding::unary;
  }
}

std::string Spellings::words(Op op) const {
  std::string text;
  for (Piece const &piece : (*this)[op].pieces) text += piece.operand < 0 ? piece.text : " ";
  return text;
}

std::string Spellings::apply(Op op, std::string_view x, std::string_view y) const {
  std::array const operands = {x, y};
  std::string text;
  for (Piece const &piece : (*this)[op].pieces)
    text += piece.operand < 0 ? std::string_view(piece.text) : operands[static_cast<std::size_t>(piece.operand)];
  return text;
}

std::vector<std::string> bridge_names(Graph const &graph, Language const &language) {
  if (!language.externals.bridge.is_given()) return {};
  NameRules const &rules = language.names;
  std::vector<std::string> names;
  std::set<std::string> given;
  for (External const &external : graph.externals) {
    std::string const base = rules.spelled("call_" + external.name.substr(0, 50)); // Fortran's limit: 63 characters
    std::string name = base;
    for (int k = 2; !given.insert(rules.key(name)).second; ++k) name = base + "_" + std::to_string(k);
    names.push_back(name);
  }
  return names;
}

namespace {

// Whether the name has the form of unnamed variables and arrays of calls: t1, r1, s1, a1_2.
bool is_numbered(std::string const &name) {
  auto const is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return name.size() > 1 && std::string_view("arst").find(name[0]) != std::string_view::npos && is_digit(name[1]) &&
         std::all_of(name.begin() + 2, name.end(), [&](char c) { return c == '_' || is_digit(c); });
}

std::vector<std::string> words_in(std::string const &text) {
  std::vector<std::string> words(1);
  for (char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  return words;
}

// Object-like macros of <math.h>, <stdint.h> and of the generated file.
bool is_macro(std::string_view name) {
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
bool is_of_file(Emission const &emission, std::string_view name) {
  for (std::string const &beginning : {emission.name("compute"), emission.name("preprocess"), std::string("load"),
                                       std::string("store"), std::string(emission.language.number.name)}) {
    std::string_view const number = name.substr(std::min(name.size(), beginning.size() + 1));
    if (name.starts_with(beginning + "_") && number.find_first_not_of("0123456789") == number.npos) return true;
  }
  return false;
}

// Reserved names of the generated functions, besides keywords: arrays, the status, the operations, and words that some
// compilers predefine.
std::set<std::string> own_names(Emission const &emission) {
  std::set<std::string> names = {"input",        "output",       "constants",    "parameters", "v",
                                 "failed",       "unix",         "linux",        "i386",       "at_run",
                                 "kept_integer", "keep_integer", "report_value", "all_finite"};
  if (emission.plan.angles.size() != 0)
    names.insert({"sine", "cosine", "angle", "sines_and_cosines", "sines_and_cosines_within",
                  std::string(name_of(Array::computed_angle))});
  names.insert(emission.local_names.begin(), emission.local_names.end());
  for (OperationInfo const &operation : operations()) {
    names.emplace(operation.c);
    for (Spellings::Piece const &piece : emission.spellings[operation.op].pieces)
      for (std::string const &word : words_in(piece.text)) names.insert(word);
  }
  return names;
}

// Separator between a name and its number.
char joint(NameRules const &rules) { return rules.has_underscores ? '_' : '$'; }

} // namespace

VariableNames::VariableNames(Emission const &emission, PlanFunction const &body)
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
