#include "engine/emit/print/external_names.h"

#include "engine/graph/complex_function.h"
#include "engine/graph/implicit.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace symreal {

namespace {

// Tokeniser for C: identifiers and single characters, without comments, strings and preprocessor lines.
class Tokens {
public:
  explicit Tokens(std::string_view text) : text_(text) {}

  // The next token; empty at the end.
  std::string_view next() {
    skip();
    std::size_t end = at_ + (at_ < text_.size());
    if (is_part(at_))
      while (is_part(end)) ++end;
    std::string_view const token = text_.substr(at_, end - at_);
    at_ = end;
    return token;
  }

private:
  bool is_part(std::size_t at) const {
    return at < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at])) || text_[at] == '_');
  }
  bool begins(std::string_view mark) const { return text_.substr(at_).starts_with(mark); }

  void skip() {
    while (at_ < text_.size()) {
      if (begins("/*")) {
        at_ = std::min(text_.find("*/", at_ + 2), text_.size() - 2) + 2;
      } else if (begins("#")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (begins("\"")) {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) at_ += text_[at_] == '\\';
        at_ = std::min(at_ + 1, text_.size());
      } else if (std::isspace(static_cast<unsigned char>(text_[at_]))) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Macros of <math.h> and <stdbool.h>, which would change a prototype of that name.
bool is_macro(std::string_view name) {
  static constexpr std::string_view macros[] = {
      "bool",        "true",          "false",       "isnan",     "isinf",    "isfinite",
      "isnormal",    "signbit",       "fpclassify",  "isgreater", "isless",   "isgreaterequal",
      "islessequal", "islessgreater", "isunordered", "NAN",       "INFINITY", "HUGE_VAL"};
  return std::ranges::find(macros, name) != std::end(macros);
}

bool is_of_mathematical_library(std::string_view name) {
  return std::ranges::any_of(operations(), [&](OperationInfo const &operation) {
    return operation.form == Form::call && operation.c == name;
  });
}

// Declaration counts of names, and names in other roles.
struct Names {
  std::map<std::string_view, std::size_t> declarations;
  std::set<std::string_view> others;

  void look_at(std::string_view text) {
    Tokens tokens(text);
    std::string_view before;
    for (std::string_view token = tokens.next(); !token.empty();) {
      std::string_view const behind = tokens.next();
      if (auto const found = declarations.find(token); found != declarations.end()) {
        bool const is_behind_type = !before.empty() && before != "return" && (before == "*" || is_word(before));
        if (behind != "(" || before == ".") others.insert(found->first);
        found->second += is_behind_type;
      }
      before = token;
      token = behind;
    }
  }

private:
  static bool is_word(std::string_view token) {
    return std::isalnum(static_cast<unsigned char>(token[0])) || token[0] == '_';
  }
};

} // namespace

void require_other_names(Emission const &emission, std::vector<EmittedFile> const &files) {
  Language const &language = emission.language;
  if (!language.externals.call || emission.uses.externals.empty()) return;
  Names names;
  for (std::size_t const number : emission.uses.externals) names.declarations[emission.graph().externals[number].name];
  for (EmittedFile const &file : files) names.look_at(file.text);
  for (std::size_t const number : emission.uses.externals) {
    External const &external = emission.graph().externals[number];
    std::string const &name = external.name;
    if (is_implicit(external) || find_complex_function(external) || is_of_mathematical_library(name)) continue;
    bool const is_word = language.has_namespace && language.names.is_keyword(name);
    bool const is_function_alone = names.declarations[name] <= 1 && !names.others.contains(name);
    if (name != "main" && !is_word && !is_macro(name) && is_function_alone) continue;
    bool const is_own = name == "compute" || name == "preprocess" || name == "guard_text";
    fail(DiagnosticId::bad_option, external.place,
         "kernel '" + emission.graph().kernel + "' calls '" + name +
             "', and code of --lang=" + std::string(language.name) + " has that name for something else: " +
             (is_own ? "give its own functions a --prefix" : "call a function of another name that calls this one"));
  }
}

} // namespace symreal
