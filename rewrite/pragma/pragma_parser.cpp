#include "rewrite/pragma/pragma_parser.h"

#include "rewrite/facts/tables.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

bool opens(std::string const &text) { return text == "(" || text == "[" || text == "{"; }
bool closes(std::string const &text) { return text == ")" || text == "]" || text == "}"; }

class Parser {
public:
  explicit Parser(std::vector<PragmaToken> const &tokens) : tokens_(tokens) {}

  std::variant<Pragma, PragmaError> run() {
    try {
      Pragma pragma;
      if (at_ < tokens_.size() && tokens_[at_].text == "function") pragma.is_function = true, ++at_;
      if (at_ == tokens_.size()) fail(at_, "a clause is missing, such as input(q)");
      while (at_ < tokens_.size()) pragma.clauses.push_back(clause(pragma.is_function));
      return pragma;
    } catch (PragmaError const &error) {
      return error;
    }
  }

private:
  [[noreturn]] static void fail(std::size_t token, std::string message, DiagnosticId id = DiagnosticId::pragma_syntax) {
    throw PragmaError{token, id, std::move(message)};
  }

  PragmaClause clause(bool is_function) {
    PragmaClause clause{.name = at_, .arguments = {}, .items = {}};
    std::string const &name = tokens_[at_].text;
    if (!tokens_[at_].is_name) fail(at_, "expected the name of a clause, found '" + name + "'");
    check_name(name, is_function);
    auto const known = find_clause(name); // which check_name has looked for
    if (known && info(*known).has(trait::BARE)) {
      clause.arguments = {++at_, at_};
      return clause;
    }
    if (++at_ == tokens_.size() || tokens_[at_].text != "(") fail(at_, "expected '(' after '" + name + "'");
    std::size_t const open = at_;
    std::size_t const close = matching(open);
    clause.arguments = {open + 1, close};
    if (info(*find_clause(name)).has(trait::WORDS)) {
      if (clause.arguments.empty()) fail(close, "expected the name of an output in '" + name + "'");
      at_ = close + 1;
      return clause;
    }
    for (std::size_t begin = open + 1; begin <= close;) {
      std::size_t const end = end_of_item(begin, close);
      if (begin == end) fail(end, "expected an expression in '" + name + "'");
      clause.items.push_back(item({begin, end}));
      begin = end + 1;
    }
    at_ = close + 1;
    return clause;
  }

  void check_name(std::string const &name, bool is_function) const {
    if (name == "external") fail(at_, "external(...) begins a pragma of its own");
    std::optional<Clause> const clause = find_clause(name);
    if (!clause) fail(at_, "unknown clause '" + name + "'", DiagnosticId::pragma_unknown_clause);
    if ((info(*clause).where & (is_function ? trait::FUNCTION : trait::BLOCK)) == 0)
      fail(at_, "'" + name + "' does not belong in " + (is_function ? "a function pragma" : "a pragma in a block"));
  }

  std::size_t matching(std::size_t open) const {
    std::vector<std::size_t> pending;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      std::string const &text = tokens_[i].text;
      if (opens(text)) pending.push_back(i);
      if (!closes(text)) continue;
      char const expected = tokens_[pending.back()].text == "(" ? ')' : tokens_[pending.back()].text == "[" ? ']' : '}';
      if (text[0] != expected) fail(i, std::string("expected '") + expected + "', found '" + text + "'");
      pending.pop_back();
      if (pending.empty()) return i;
    }
    char const missing = tokens_[pending.back()].text == "(" ? ')' : tokens_[pending.back()].text == "[" ? ']' : '}';
    fail(tokens_.size(), std::string("expected '") + missing + "' before the end of the line");
  }

  std::size_t end_of_item(std::size_t begin, std::size_t close) const {
    for (std::size_t i = begin; i < close; ++i) {
      if (opens(tokens_[i].text))
        i = matching(i);
      else if (tokens_[i].text == ",")
        return i;
    }
    return close;
  }

  PragmaItem item(TokenRange range) const {
    PragmaItem item{.tokens = range, .sections = {}};
    for (std::size_t i = range.begin; i < range.end; ++i) {
      if (!opens(tokens_[i].text)) continue;
      std::size_t const close = matching(i);
      if (tokens_[i].text == "[")
        if (std::size_t const colon = colon_of_section(i + 1, close); colon != close) {
          if (i == range.begin) fail(i, "expected an array before the section");
          if (colon + 1 == close) fail(close, "expected the length of the section after ':'");
          item.sections.push_back({{i, close + 1}, {i + 1, colon}, {colon + 1, close}});
        }
      i = close;
    }
    return item;
  }

  // The colon between low and length, or `close`. A colon that belongs to a `?` does not count.
  std::size_t colon_of_section(std::size_t begin, std::size_t close) const {
    std::size_t found = close;
    int questions = 0;
    for (std::size_t i = begin; i < close; ++i) {
      std::string const &text = tokens_[i].text;
      if (opens(text))
        i = matching(i);
      else if (text == "?")
        ++questions;
      else if (text == ":" && questions > 0)
        --questions;
      else if (text == ":" && found != close)
        fail(i, "a section has a low index and a length, and no stride");
      else if (text == ":")
        found = i;
    }
    return found;
  }

  std::vector<PragmaToken> const &tokens_;
  std::size_t at_ = 0;
};

PragmaError syntax(std::size_t token, std::string message) {
  return {token, DiagnosticId::pragma_syntax, std::move(message)};
}

// The names in external(name) and derivative(name, name), which may be qualified; `at` stands on the word before them,
// and is left behind the closing parenthesis.
std::vector<ExternalPragma::DerivativeName> function_names(std::vector<PragmaToken> const &tokens,
                                                           std::vector<Place> const &places, std::size_t &at) {
  std::string const word = tokens[at].text;
  if (++at == tokens.size() || tokens[at].text != "(") throw syntax(at, "expected '(' after '" + word + "'");
  std::vector<ExternalPragma::DerivativeName> names(1);
  for (++at; at < tokens.size() && tokens[at].text != ")"; ++at) {
    ExternalPragma::DerivativeName &last = names.back();
    if (tokens[at].text == "," && !last.name.empty()) {
      names.emplace_back();
      continue;
    }
    if (!tokens[at].is_name && tokens[at].text != "::") throw syntax(at, "expected the name of a function");
    if (last.name.empty()) last.place = places[at];
    last.name += tokens[at].text;
  }
  if (at == tokens.size()) throw syntax(at, "expected ')' before the end of the line");
  if (names.back().name.empty()) throw syntax(at, "expected the name of a function");
  ++at;
  return names;
}

ExternalPragma::Item read_item(std::vector<PragmaToken> const &tokens, PragmaItem const &item, std::size_t offset) {
  std::size_t const begin = item.tokens.begin;
  if (!tokens[begin].is_name) throw syntax(offset + begin, "expected the name of a parameter");
  ExternalPragma::Item result{tokens[begin].text, {}, {}};
  std::size_t next = begin + 1;
  for (PragmaSection const &section : item.sections) {
    if (section.brackets.begin != next) throw syntax(offset + next, "expected a section, as in q[0:3]");
    if (!section.low.empty() && text_of(tokens, section.low) != "0")
      throw syntax(offset + section.low.begin, "an array of an external function begins at 0");
    result.lengths.push_back(text_of(tokens, section.length));
    next = section.brackets.end;
  }
  if (next != item.tokens.end) throw syntax(offset + next, "expected a section, as in q[0:3]");
  return result;
}

} // namespace

std::variant<Pragma, PragmaError> parse_pragma(std::vector<PragmaToken> const &tokens) { return Parser(tokens).run(); }

std::string text_of(std::vector<PragmaToken> const &tokens, TokenRange range) {
  std::string text;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    if (i > range.begin && tokens[i].space_before) text += ' ';
    text += tokens[i].text;
  }
  return text;
}

std::string element_text(std::vector<PragmaToken> const &tokens, PragmaItem const &item) {
  std::string text;
  std::size_t at = item.tokens.begin;
  for (std::size_t k = 0; k < item.sections.size(); ++k) {
    PragmaSection const &section = item.sections[k];
    std::string const low = section.low.empty() ? "0" : text_of(tokens, section.low);
    text += text_of(tokens, {at, section.brackets.begin}) + "[(" + low + ")+symreal_i[" + std::to_string(k) + "]]";
    at = section.brackets.end;
  }
  return text + text_of(tokens, {at, item.tokens.end});
}

std::string base_text(std::vector<PragmaToken> const &tokens, PragmaItem const &item) {
  std::string text;
  std::size_t at = item.tokens.begin;
  for (PragmaSection const &section : item.sections) {
    text += text_of(tokens, {at, section.brackets.begin});
    at = section.brackets.end;
  }
  return text + text_of(tokens, {at, item.tokens.end});
}

std::variant<ExternalPragma, PragmaError> parse_external(std::vector<PragmaToken> const &tokens,
                                                         std::vector<Place> const &places) try {
  ExternalPragma pragma;
  std::size_t at = 0;
  std::vector<ExternalPragma::DerivativeName> const names = function_names(tokens, places, at);
  if (names.size() > 1) return syntax(2, "one function is named in a pragma 'external'");
  pragma.function = names[0].name;
  pragma.name_place = names[0].place;
  std::vector<PragmaToken> rest;
  std::vector<std::size_t> position; // in the whole directive
  int depth = 0;
  for (; at < tokens.size(); ++at) {
    if (depth == 0 && tokens[at].text == "derivative") {
      if (!pragma.derivatives.empty()) return syntax(at, "'derivative' stands there twice");
      pragma.derivatives = function_names(tokens, places, at);
      --at;
      continue;
    }
    depth += (tokens[at].text == "(") - (tokens[at].text == ")");
    if (depth == 0 && tokens[at].text == "pure") {
      pragma.pure = true;
      continue;
    }
    rest.push_back(tokens[at]);
    position.push_back(at);
  }
  position.push_back(tokens.size());
  if (rest.empty()) return pragma;
  auto const parsed = parse_pragma(rest);
  if (auto const *error = std::get_if<PragmaError>(&parsed))
    return PragmaError{position[error->token], error->id, error->message};
  for (PragmaClause const &clause : std::get<Pragma>(parsed).clauses) {
    std::string const &name = rest[clause.name].text;
    if (name != "input" && name != "output")
      return syntax(position[clause.name],
                    "beside external(...) stand pure, input(...), output(...) and derivative(...)");
    for (PragmaItem const &item : clause.items) {
      (name == "input" ? pragma.inputs : pragma.outputs).push_back(read_item(rest, item, position[0]));
      (name == "input" ? pragma.inputs : pragma.outputs).back().place = places[position[item.tokens.begin]];
    }
  }
  return pragma;
} catch (PragmaError const &error) {
  return error;
}

} // namespace symreal::rewrite
