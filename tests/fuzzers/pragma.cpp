// The tokens of a directive. Of one that is taken all that asks for its text is called.
#include "fuzzer.h"
#include "rewrite/pragma/pragma_parser.h"

#include <cctype>
#include <utility>

using namespace symreal;
using namespace symreal::rewrite;

static std::vector<PragmaToken> tokens_of(std::string_view text) {
  auto const is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
  std::vector<PragmaToken> tokens;
  bool space_before = false;
  for (std::size_t begin = 0; begin < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[begin]))) {
      space_before = true;
      ++begin;
      continue;
    }
    std::size_t end = begin + 1;
    if (is_word(text[begin]))
      while (end < text.size() && is_word(text[end])) ++end;
    bool const is_name = is_word(text[begin]) && !std::isdigit(static_cast<unsigned char>(text[begin]));
    tokens.push_back({std::string(text.substr(begin, end - begin)), is_name, std::exchange(space_before, false)});
    begin = end;
  }
  return tokens;
}

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  std::vector<PragmaToken> const tokens = tokens_of(fuzz::text_of(data, size));
  auto const parsed = parse_pragma(tokens);
  if (auto const *error = std::get_if<PragmaError>(&parsed)) {
    internal_check(error->token <= tokens.size() && !error->message.empty());
    return 0;
  }
  for (PragmaClause const &clause : std::get<Pragma>(parsed).clauses) {
    internal_check(clause.name < tokens.size());
    text_of(tokens, clause.arguments);
    for (PragmaItem const &item : clause.items) {
      internal_check(!item.tokens.empty() && item.tokens.end <= tokens.size());
      element_text(tokens, item);
      base_text(tokens, item);
    }
  }
  return 0;
}
