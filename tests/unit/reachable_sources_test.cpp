#include "rewrite/unit/reachable_sources.h"

#include "engine/diagnostics/diagnostic.h"

#include <gtest/gtest.h>

namespace symreal::rewrite {
namespace {

using Numbers = std::set<std::size_t>;

struct Source {
  std::string text;
  SourceLinks links;
};

struct Sources {
  std::vector<Source> all;
  std::vector<std::size_t> read = {};

  ReachableSources reach(std::set<std::size_t> const &begin) {
    Candidates candidates;
    for (std::size_t k = 0; k < all.size(); ++k) candidates.names.push_back(std::to_string(k) + ".c");
    candidates.text = [this](std::size_t k) { return all[k].text; };
    candidates.read = [this](std::vector<std::size_t> const &numbers) {
      std::vector<SourceLinks> links;
      for (std::size_t const k : numbers) {
        read.push_back(k);
        links.push_back(all[k].links);
      }
      return links;
    };
    return reachable_sources(candidates, begin);
  }
};

Source start(std::string const &needs) { return {"main", {{{"main", {needs}}}, {{needs, needs}}}}; }

TEST(ReachableSources, GoesFromSymbolToSymbol) {
  Sources sources{{start("f"),
                   {"f unused", {{{"f", {"g"}}, {"unused", {"h"}}}, {{"g", "g"}, {"h", "h"}}}},
                   {"h", {{{"h", {}}}, {}}},
                   {"g", {{{"g", {}}}, {}}}}};
  ReachableSources const found = sources.reach({0});
  EXPECT_EQ(found.sources, (Numbers{0, 1, 3}));
  EXPECT_EQ(found.symbols, (std::set<std::string>{"f", "g", "main"}));
  EXPECT_EQ(sources.read, (std::vector<std::size_t>{0, 1, 3})) << "what lacks the word is not read";
}

TEST(ReachableSources, CountsWhatASourceRunsAtTheStart) {
  Sources sources{
      {start("f"), {"f", {{{"f", {}}, {"", {"make"}}}, {{"make", "make"}}}}, {"make", {{{"make", {}}}, {}}}}};
  EXPECT_EQ(sources.reach({0}).sources, (Numbers{0, 1, 2}));
}

TEST(ReachableSources, FindsMain) {
  Sources sources{{{"f", {{{"f", {}}}, {}}}, start("f"), {"other", {}}}};
  EXPECT_EQ(sources.reach({}).sources, (Numbers{0, 1}));
}

TEST(ReachableSources, AsksWhichOfSeveralIsMeant) {
  Sources sources{{start("f"), {"f", {{{"f", {}}}, {}}}, {"f", {{{"f", {}}}, {}}}}};
  try {
    sources.reach({0});
    FAIL() << "took one of two";
  } catch (DiagnosticError const &error) {
    EXPECT_NE(error.diagnostic().message.find("'f' is defined in 1.c and 2.c"), std::string::npos);
  }
  EXPECT_EQ(sources.reach({0, 2}).sources, (Numbers{0, 2})) << "the one that is named";
}

TEST(ReachableSources, LeavesWhatNoSourceDefinesToTheLinker) {
  Sources sources{{start("cos"), {"a comment on cos", {}}}};
  EXPECT_EQ(sources.reach({0}).sources, (Numbers{0}));
}

} // namespace
} // namespace symreal::rewrite
