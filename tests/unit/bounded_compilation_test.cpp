#include "program/build/bounded_compilation.h"

#include <gtest/gtest.h>
#include <map>

namespace symreal::program {
namespace {

class Memory : public rewrite::KeptTexts {
public:
  std::optional<std::string> find(std::string const &key) override {
    auto const found = texts_.find(key);
    return found == texts_.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(std::string const &key, std::string const &text) override { texts_[key] = text; }

private:
  std::map<std::string, std::string> texts_;
};

// A compiler that takes so long, as it would be seen through a limit.
class Compiler {
public:
  Compiler(double usual, double unoptimised, double original)
      : seconds_{{"usual", usual}, {"unoptimised", unoptimised}, {"original", original}} {}

  Captured compile(bool is_large = false, double reading = 0) {
    BoundedRun run;
    run.compile = run.measure = [this](Command const &command) { return ended(command); };
    run.tell = [this](std::string const &text) { told.push_back(text); };
    run.kept = &kept_;
    run.key = "key";
    return compile_bounded({{{"usual"}}, {{"unoptimised"}}, {{"original"}}, "model.c", is_large, reading}, run);
  }

  std::vector<std::string> ran, told;
  double seconds = 0; // of all

private:
  Captured ended(Command const &command) {
    std::string const &name = command.arguments[0];
    ran.push_back(name);
    double const takes = seconds_.at(name);
    double limit = command.processor_limit.seconds;
    if (limit > 0 && takes > limit && command.processor_limit.further) limit = command.processor_limit.further();
    if (takes < 0) return {{Ending::exited, 1}, {}};
    bool const ends = limit == 0 || takes <= limit;
    seconds += ends ? takes : limit;
    return {{ends ? Ending::exited : Ending::over_limit, 0, takes, ends ? takes : limit, 100}, {}};
  }

  std::map<std::string, double> seconds_;
  Memory kept_;
};

using Words = std::vector<std::string>;

TEST(BoundedCompilation, WhatIsQuickIsNotMeasured) {
  Compiler compiler(1.9, 3, 0.1);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, Words{"usual"});
  EXPECT_TRUE(compiler.told.empty());
}

TEST(BoundedCompilation, AnyOtherWaitsForTheMeasureAndGoesOn) {
  Compiler compiler(7.9, 10, 4);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original"}));
  EXPECT_TRUE(compiler.told.empty());
}

TEST(BoundedCompilation, ASmallSourceIsFinishedWithinTheBound) {
  Compiler compiler(2.7, 2, 0.2);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original"}));
  EXPECT_LE(compiler.seconds, 10 * 0.2 + 1);
}

TEST(BoundedCompilation, ALargeSourceIsMeasuredAfterASecond) {
  Compiler compiler(145, 5, 0.7);
  EXPECT_TRUE(compiler.compile(/*is_large=*/true).outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original", "unoptimised"}));
  ASSERT_EQ(compiler.told.size(), 1u);
  EXPECT_LE(compiler.seconds, 10 * 0.7 + 1);
  Compiler quick(0.9, 5, 0.7);
  EXPECT_TRUE(quick.compile(/*is_large=*/true).outcome.success());
  EXPECT_EQ(quick.ran, Words{"usual"});
}

TEST(BoundedCompilation, ASourceWithLargeHeadersIsMeasuredLater) {
  Compiler compiler(11, 8, 5);
  EXPECT_TRUE(compiler.compile(/*is_large=*/true, /*reading=*/4).outcome.success());
  EXPECT_EQ(compiler.ran, Words{"usual"});
}

TEST(BoundedCompilation, BeyondItsShareOptimisationGoesAndIsToldOf) {
  Compiler compiler(145, 20, 3);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original", "unoptimised"}));
  ASSERT_EQ(compiler.told.size(), 1u);
  EXPECT_EQ(compiler.told[0], "model.c is compiled without optimisation in symbolic mode: with it the compiler takes "
                              "more than 6 s, where the original at -O1 takes 3.0 s");
  EXPECT_LE(compiler.seconds, 10 * 3 + 1);
  // Another time nothing is tried, and the same is said.
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original", "unoptimised", "unoptimised"}));
  ASSERT_EQ(compiler.told.size(), 2u);
  EXPECT_EQ(compiler.told[1], compiler.told[0]);
}

TEST(BoundedCompilation, AnOriginalThatDoesNotCompileSetsNoLimit) {
  Compiler compiler(145, 20, -1);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original"}));
}

TEST(BoundedCompilation, WhereThatDoesNotSufficeTheFigureIsTold) {
  Compiler compiler(900, 70, 4);
  EXPECT_TRUE(compiler.compile().outcome.success());
  EXPECT_EQ(compiler.ran, (Words{"usual", "original", "unoptimised"}));
  ASSERT_EQ(compiler.told.size(), 2u);
  EXPECT_NE(compiler.told[1].find("takes 70 s"), std::string::npos) << compiler.told[1];
  EXPECT_NE(compiler.told[1].find("all that was tried 82 s"), std::string::npos) << compiler.told[1];
  EXPECT_NE(compiler.told[1].find("--record=instructions"), std::string::npos) << compiler.told[1];
}

} // namespace
} // namespace symreal::program
