#include "rewrite/pragma/pragma_parser.h"

#include <gtest/gtest.h>

#include <cctype>

using namespace symreal;
using namespace symreal::rewrite;

namespace {

// Names and numbers are tokens, anything else is one token a character.
std::vector<PragmaToken> tokens(std::string const &text) {
  std::vector<PragmaToken> result;
  bool space = false;
  for (std::size_t i = 0; i < text.size();) {
    auto const is_word = [&](std::size_t at) {
      return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    if (text[i] == ' ') {
      space = true;
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (is_word(i) && is_word(end)) ++end;
    result.push_back({text.substr(i, end - i), std::isalpha(static_cast<unsigned char>(text[i])) != 0, space});
    space = false;
    i = end;
  }
  return result;
}

PragmaError error(std::string const &text) {
  auto const parsed = parse_pragma(tokens(text));
  auto const *found = std::get_if<PragmaError>(&parsed);
  EXPECT_TRUE(found) << text;
  return found ? *found : PragmaError{};
}

} // namespace

TEST(PragmaParser, ItemsAndTheirSections) {
  std::vector<PragmaToken> const words = tokens("input(q[0:n], c[:3][k] . x) output(f(a, b)[i ? 1 : 2 : 4])");
  auto const pragma = std::get<Pragma>(parse_pragma(words));
  EXPECT_FALSE(pragma.is_function);
  ASSERT_EQ(pragma.clauses.size(), 2u);
  ASSERT_EQ(pragma.clauses[0].items.size(), 2u);
  EXPECT_EQ(element_text(words, pragma.clauses[0].items[0]), "q[(0)+symreal_i[0]]");
  EXPECT_EQ(base_text(words, pragma.clauses[0].items[1]), "c[k] . x");
  EXPECT_EQ(element_text(words, pragma.clauses[0].items[1]), "c[(0)+symreal_i[0]][k] . x");
  PragmaItem const &call = pragma.clauses[1].items[0];
  EXPECT_EQ(element_text(words, call), "f(a, b)[(i ? 1 : 2)+symreal_i[0]]");
  EXPECT_EQ(text_of(words, call.sections[0].length), "4");
}

TEST(PragmaParser, ErrorsNameTheirToken) {
  EXPECT_EQ(error("").id, DiagnosticId::pragma_syntax);
  EXPECT_EQ(error("inputs(q)").id, DiagnosticId::pragma_unknown_clause);
  EXPECT_EQ(error("input(q) external(f)").token, 4u);
  EXPECT_EQ(error("input q").token, 1u);
  EXPECT_EQ(error("input(q").token, 3u);
  EXPECT_EQ(error("input(q[0:1)").token, 7u);
  EXPECT_EQ(error("input(q[0:1:2])").token, 7u);
  EXPECT_EQ(error("input(q,)").token, 4u);
  EXPECT_EQ(error("input()").token, 2u);
  EXPECT_EQ(error("function generate(q)").token, 1u);
}
