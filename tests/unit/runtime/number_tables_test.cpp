// Which loops share a table, and that every iteration finds its numbers there.
#include "engine/emit/print/loop_indices.h"
#include "engine/emit/print/number_tables.h"
#include "engine/plan/loop_function.h"

#include <gtest/gtest.h>
#include <random>

namespace symreal {
namespace {

using reroll::Leaf;
using reroll::LoopStep;
using Column = std::vector<double>;

LoopStep step_of(std::uint32_t count, std::vector<Column> const &columns) {
  LoopStep step{.body = {}, .count = count};
  for (Column const &column : columns) {
    step.leaves.push_back({Array::memory, {0, 1}});
    step.leaves.push_back({Array::values, {}, column});
  }
  return step;
}

Column column_of(std::size_t length, std::mt19937 &random) {
  Column column(length);
  for (double &value : column) value = std::uniform_real_distribution<>(-1, 1)(random);
  return column;
}

Column part(Column const &column, std::size_t first, std::size_t count, bool is_backwards = false) {
  Column result;
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(column[(is_backwards ? first + column.size() - k : first + k) % column.size()]);
  return result;
}

// What the text reads for a leaf in an iteration.
double number(NumberTables const &numbers, std::size_t step, std::size_t leaf, std::size_t iteration) {
  auto const [walk, column] = numbers.steps()[step].places[leaf];
  TableWalk const &on = numbers.steps()[step].walks[walk];
  NumberTable const &table = numbers.tables()[on.table];
  std::size_t const row = row_of(on, table, iteration);
  return table.columns[column][table.written[table.is_listed() ? table.which[row] : row]];
}

// The number of tables, when all numbers are right.
std::size_t tables_of(std::vector<LoopStep> const &steps) {
  NumberTables const numbers(steps);
  for (std::size_t s = 0; s < steps.size(); ++s)
    for (std::size_t leaf = 0; leaf < steps[s].leaves.size(); ++leaf)
      for (std::uint32_t k = 0; k < steps[s].count && steps[s].leaves[leaf].array == Array::values; ++k)
        EXPECT_EQ(number(numbers, s, leaf, k), value_at(steps[s].leaves[leaf], k, {}));
  return numbers.tables().size();
}

TEST(NumberTables, AreSharedBackwardsAndFromAnotherPlace) {
  std::mt19937 random(1);
  Column const a = column_of(7, random), b = column_of(7, random);
  for (bool const is_backwards : {false, true})
    for (std::size_t first = 0; first < 7; ++first) // again and again, from there
      EXPECT_EQ(tables_of({step_of(30, {a, b}),
                           step_of(25, {part(b, first, 7, is_backwards), part(a, first, 7, is_backwards)})}),
                1);
  Column const c = column_of(30, random), d = column_of(30, random);
  for (std::size_t first = 0; first < 4; ++first) { // once, in front of the end
    EXPECT_EQ(tables_of({step_of(26, {part(c, first, 26), part(d, first, 26)}), step_of(30, {c, d})}), 1);
    EXPECT_EQ(tables_of({step_of(26, {part(c, 29 - first, 26, true)}), step_of(30, {c, d})}), 1);
  }
}

TEST(NumberTables, AreReadInSeveralPlacesByOneLoop) {
  std::mt19937 random(2);
  Column const a = column_of(7, random), b = column_of(7, random), c = column_of(7, random);
  NumberTables const numbers({step_of(30, {a, b, c}), step_of(30, {part(a, 1, 7), part(b, 2, 7), c})});
  EXPECT_EQ(numbers.tables().size(), 1);
  EXPECT_EQ(numbers.tables().front().columns.size(), 3);
  EXPECT_EQ(numbers.steps().back().walks.size(), 3);
}

TEST(NumberTables, TakeWhatIsNewWhereAllTheirRowsAreRead) {
  std::mt19937 random(3);
  Column const a = column_of(7, random), b = column_of(7, random), c = column_of(7, random);
  EXPECT_EQ(tables_of({step_of(30, {a, b}), step_of(30, {part(a, 3, 7, true), c})}), 1);
  Column const d = column_of(30, random), e = column_of(28, random);
  EXPECT_EQ(tables_of({step_of(30, {d}), step_of(28, {part(d, 1, 28), e})}), 2);
}

TEST(NumberTables, AreNotSharedByOtherNumbers) {
  std::mt19937 random(4);
  EXPECT_EQ(tables_of({step_of(30, {column_of(7, random)}), step_of(30, {column_of(7, random)})}), 2);
  EXPECT_EQ(tables_of({step_of(30, {column_of(7, random)}), step_of(30, {column_of(5, random)})}), 2);
  Column once = column_of(7, random), again = once;
  again[3] = -again[3];
  EXPECT_EQ(tables_of({step_of(30, {once}), step_of(30, {again})}), 2);
  // 0 is not -0, and seven numbers in turn are not seven in a row.
  EXPECT_EQ(tables_of({step_of(30, {{0.0, 1, 2}}), step_of(30, {{-0.0, 1, 2}})}), 2);
  EXPECT_EQ(tables_of({step_of(30, {once}), step_of(7, {once})}), 2);
}

TEST(NumberTables, WriteRowsThatAreAlikeOnce) {
  Column few(40, 1.5);
  few[7] = few[23] = 2.5;
  NumberTables const numbers({step_of(40, {few}), step_of(30, {part(few, 9, 30)})});
  ASSERT_EQ(numbers.tables().size(), 1);
  EXPECT_EQ(numbers.tables().front().written.size(), 2);
  EXPECT_EQ(tables_of({step_of(40, {few}), step_of(30, {part(few, 9, 30)})}), 1);
}

// Tables cut out of a few columns in any way, with values that are often the same.
TEST(NumberTables, HoldTheNumbersOfAnySteps) {
  std::mt19937 random(5);
  auto const below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
  std::size_t shared = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Column> columns(1 + below(4), Column(3 + below(12)));
    for (Column &column : columns)
      for (double &value : column) value = static_cast<double>(below(4)) - 1;
    std::vector<LoopStep> steps;
    for (std::size_t s = 0; s < 2 + below(3); ++s) {
      std::size_t const first = below(3);
      bool const is_backwards = below(2) == 0, is_cyclic = below(2) == 0;
      auto const length =
          static_cast<std::uint32_t>(is_cyclic ? columns.front().size() : columns.front().size() - below(2));
      std::vector<Column> parts;
      for (std::size_t c = 0; c < 1 + below(4); ++c)
        parts.push_back(part(columns[below(columns.size())], first + below(2), length, is_backwards));
      steps.push_back(step_of(is_cyclic ? 2 * length + 1 : length, parts));
    }
    shared += tables_of(steps) < steps.size() ? 1 : 0;
  }
  EXPECT_GT(shared, 150);
}

TEST(Records, AreElementsOfOneStepBesideEachOther) {
  using reroll::Access;
  Records records(true);
  for (std::int64_t const first : {5, 7, 9, 12, 14, 104, 105}) records.add("v", {first, 8}, false);
  for (std::int64_t const first : {1, 2, 3}) records.add("v", {first, 1}, false);
  records.add("v", {0, 0, {1, 2, 4}}, false);
  records.add("w", {6, 8}, false);
  records.choose();
  ASSERT_EQ(records.chosen().size(), 1); // from 5 up to 12: 14 begins another with too few, 104 too
  EXPECT_EQ(records.chosen().front().first, 5);
  std::optional<Records::Place> const place = records.find("v", {9, 8}, false);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->element, 4);
  EXPECT_FALSE(records.find("v", {14, 8}, false));
  EXPECT_FALSE(records.find("v", {9, 8}, true));
  EXPECT_FALSE(records.find("v", {9, -8}, false));
  EXPECT_FALSE(records.find("w", {9, 8}, false));
}

TEST(Records, AreManyElementsWithoutALoop) {
  using reroll::Access;
  Records records(false);
  for (std::int64_t first = 1100; first < 1132; first += 2) records.add("v", {first, 0}, false);
  for (std::int64_t first = 2000; first < 2015; ++first) records.add("v", {first, 0}, false);
  for (std::int64_t first = 0; first < 40; ++first) records.add("v", {first, 0}, false);
  records.choose();
  ASSERT_EQ(records.chosen().size(), 1);
  std::optional<Records::Place> const place = records.find("v", {1130, 0}, false);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->element, 30);
  EXPECT_FALSE(records.find("v", {2000, 0}, false));
}

} // namespace
} // namespace symreal
