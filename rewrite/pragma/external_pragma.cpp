#include "rewrite/pragma/externals.h"

namespace symreal::rewrite {
namespace {

using Error = PragmaError;

Error syntax(std::size_t token, std::string message) {
  return {token, DiagnosticId::pragma_syntax, std::move(message)};
}

// The name in external(name), which may be qualified; `at` is left behind the closing parenthesis.
std::string function_name(std::vector<PragmaToken> const &tokens, std::size_t &at) {
  if (++at == tokens.size() || tokens[at].text != "(") throw syntax(at, "expected '(' after 'external'");
  std::string name;
  for (++at; at < tokens.size() && tokens[at].text != ")"; ++at) {
    if (!tokens[at].is_name && tokens[at].text != "::") throw syntax(at, "expected the name of a function");
    name += tokens[at].text;
  }
  if (at == tokens.size()) throw syntax(at, "expected ')' before the end of the line");
  if (name.empty()) throw syntax(at, "expected the name of a function");
  ++at;
  return name;
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
  pragma.function = function_name(tokens, at);
  pragma.name_place = places[2];
  std::vector<PragmaToken> rest;
  std::vector<std::size_t> position; // in the whole directive
  int depth = 0;
  for (; at < tokens.size(); ++at) {
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
      return syntax(position[clause.name], "beside external(...) stand pure, input(...) and output(...)");
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
