#include "runtime/memory/memory_image.h"

#include <cstring>
#include <gtest/gtest.h>

using namespace symreal::memory;

namespace {

int counter = 1;
double table[4] = {1, 2, 3, 4};
char text[16] = "before";
double const constant[2] = {1, 2};

struct Owner {
  double *numbers;
};
Owner owner{};

int once() {
  static int const value = counter + 1; // initialised when this is called first
  return value;
}

std::vector<Change> changes_named(std::vector<Change> const &changes, std::string const &name) {
  std::vector<Change> found;
  for (Change const &one : changes)
    if (one.name.find(name) != std::string::npos) found.push_back(one);
  return found;
}

// As a kernel that is given a caller's object. What it finds is not returned: that would change the caller's stack.
std::vector<Change> left;
[[gnu::noinline]] void left_by_writing(double *number) {
  MemoryImage const image = MemoryImage::capture(__builtin_frame_address(0));
  *number = 5;
  left = image.changes({});
}

} // namespace

TEST(MemoryImage, FindsStaticObjectsThatChange) {
  MemoryImage const image = MemoryImage::capture(nullptr);
  EXPECT_TRUE(image.changes({}).empty());
  ++counter;
  table[2] = -1;
  std::strcpy(text, "after");
  std::vector<Change> const changes = image.changes({});
  ASSERT_EQ(changes_named(changes, "counter").size(), 1u);
  ASSERT_EQ(changes_named(changes, "text").size(), 1u);
  std::vector<Change> const numbers = changes_named(changes, "table");
  ASSERT_EQ(numbers.size(), 1u);
  EXPECT_EQ(numbers[0].region, Region::static_object);
  EXPECT_EQ(numbers[0].size, sizeof table);
  EXPECT_EQ(numbers[0].first / sizeof(double), 2u);
  EXPECT_LE(numbers[0].end, 3 * sizeof(double));
}

TEST(MemoryImage, LeavesOutWhatIsKnown) {
  MemoryImage const image = MemoryImage::capture(nullptr);
  table[1] += 1;
  table[3] += 1;
  std::vector<Known> const known = {{reinterpret_cast<char *>(&table[1]), sizeof(double)}};
  std::vector<Change> const numbers = changes_named(image.changes(known), "table");
  ASSERT_EQ(numbers.size(), 1u);
  EXPECT_EQ(numbers[0].first / sizeof(double), 3u);
}

TEST(MemoryImage, LeavesOutAFirstInitialisation) {
  MemoryImage const image = MemoryImage::capture(nullptr);
  EXPECT_GT(once(), 0);
  EXPECT_TRUE(image.changes({}).empty());
}

TEST(MemoryImage, FindsTheCallersObjects) {
  double here = 1;
  left_by_writing(&here);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].region, Region::stack);
  char *const at = left[0].object + left[0].first;
  EXPECT_GE(at, reinterpret_cast<char *>(&here));
  EXPECT_LT(at, reinterpret_cast<char *>(&here + 1));
}

TEST(MemoryImage, FindsBlocksOfTheHeapAndWhoOwnsThem) {
  double numbers[3] = {1, 2, 3};
  note_allocated(numbers, sizeof numbers, &counter); // as the allocation functions tell
  owner.numbers = numbers;
  MemoryImage const image = MemoryImage::capture(nullptr);
  numbers[1] = 7;
  std::vector<Change> const changes = image.changes({});
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].region, Region::heap_block);
  EXPECT_EQ(changes[0].first / sizeof(double), 1u);
  EXPECT_TRUE(image.changes(image.owned({reinterpret_cast<char *>(&owner), sizeof owner})).empty());
  note_released(numbers);
  EXPECT_TRUE(image.changes({}).empty());
  EXPECT_EQ(image.before(constant), nullptr);
}
