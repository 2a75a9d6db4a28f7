#include "rewrite/pragma/externals.h"

namespace symreal::rewrite {
namespace {

using Error = PragmaError;

Error syntax(std::size_t token, std::string message) {
  return {token, DiagnosticId::pragma_syntax, std::move(message)};
}

// The names in external(name) and derivative(name, name), which may be qualified; `at` stands on the word before them,
// and is left behind the closing parenthesis.
std::vector<ExternalPragma::Function> function_names(std::vector<PragmaToken> const &tokens,
                                                     std::vector<Place> const &places, std::size_t &at) {
  std::string const word = tokens[at].text;
  if (++at == tokens.size() || tokens[at].text != "(") throw syntax(at, "expected '(' after '" + word + "'");
  std::vector<ExternalPragma::Function> names(1);
  for (++at; at < tokens.size() && tokens[at].text != ")"; ++at) {
    ExternalPragma::Function &last = names.back();
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

std::variant<ExternalPragma, PragmaError> parse_external(std::vector<PragmaToken> const &tokens,
                                                         std::vector<Place> const &places) try {
  ExternalPragma pragma;
  std::size_t at = 0;
  std::vector<ExternalPragma::Function> const names = function_names(tokens, places, at);
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
