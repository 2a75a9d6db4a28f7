#include "rewrite/facts/facts.h"

#include <gtest/gtest.h>

namespace symreal::rewrite {
namespace {

Facts some_facts() {
  Facts facts;
  Span const span{"/a/model.cpp", 10, 300};
  facts.files["/a/model.cpp"] = {"model.cpp", "model.cpp", "double x;\n", {{span, true}}, {{3, "X"}}, {{1, 2}}, {}};
  facts.types = {{span, {Fate::follows}}, {{"/a/model.h", 1, 2}, {Fate::converted, "REAL", constant_variable}}};
  facts.wraps = {{span, Use::padding, "a"}, {span, Use::read, ""}};
  facts.reached["/a/model.cpp"] = std::vector<bool>{true, true, false, true};
  facts.reached["/a/model.h"] = std::vector<bool>(1000, true);
  facts.pragmas[span].configured = 3;
  facts.pragmas[span].function = {
      {"f", {"double f()", std::nullopt, true}, span, {{"x", {"model.cpp", 1, 2}}}, {}, {}}};
  facts.decisions[span].needs = span;
  facts.members[span].bases = {{span, true}};
  facts.diagnostics = {{DiagnosticId::source_error, {"model.cpp", 1, 2}, "no", {{{}, "note"}}}};
  facts.makes_text = true;
  return facts;
}

TEST(FactBytes, are_facts_again) {
  std::string const bytes = to_bytes(some_facts());
  std::optional<Facts> const facts = facts_of_bytes(bytes);
  ASSERT_TRUE(facts);
  EXPECT_EQ(to_bytes(*facts), bytes);
  EXPECT_EQ(facts->types, some_facts().types);
  EXPECT_EQ(facts->wraps, some_facts().wraps);
  EXPECT_EQ(facts->reached, some_facts().reached);
  EXPECT_EQ(facts->pragmas.begin()->second.configured, 3U);
  EXPECT_EQ(facts->diagnostics.at(0).notes.at(0).message, "note");
  EXPECT_TRUE(facts->makes_text);
}

TEST(FactBytes, are_nothing_where_a_part_is_missing_or_too_much) {
  std::string const bytes = to_bytes(some_facts());
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(facts_of_bytes(bytes.substr(0, size))) << size;
  EXPECT_FALSE(facts_of_bytes(bytes + "x"));
}

} // namespace
} // namespace symreal::rewrite
