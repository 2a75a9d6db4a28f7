#include "program/build/durable_files.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/workspace.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

std::size_t entries_of(std::string const &directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

// Whatever stands in the way of one file comes between staging and the commit.
class Staging : public testing::Test {
protected:
  Workspace workspace{false};
  std::string directory = workspace.directory("results");
  std::string old = directory + "/old", fresh = directory + "/fresh", last = directory + "/last";

  void commit_fails(std::function<void(StagedFiles &)> const &add_more) {
    write_if_changed(old, "before");
    {
      StagedFiles staged;
      staged.add(old, "after");
      staged.add(fresh, "new");
      add_more(staged);
      staged.add(last, "last");
      fs::create_directories(last + "/in_the_way");
      EXPECT_THROW(staged.commit(), DiagnosticError);
    }
    EXPECT_EQ(read_file(old), "before");
    EXPECT_FALSE(fs::exists(fresh));
  }
};

TEST_F(Staging, TakesPlaceTogether) {
  StagedFiles staged;
  std::string const below = directory + "/a/b";
  staged.make_directory(below);
  staged.add(below + "/one", "1");
  write_durably(staged.add_directory(directory + "/whole") + "/two", "2", usual_permissions());
  EXPECT_FALSE(fs::exists(below + "/one"));
  EXPECT_FALSE(fs::exists(directory + "/whole"));
  staged.commit();
  EXPECT_EQ(read_file(below + "/one"), "1");
  EXPECT_EQ(read_file(directory + "/whole/two"), "2");
  EXPECT_EQ(entries_of(directory), 2U);
}

TEST_F(Staging, NothingChangesWhereOneFails) {
  commit_fails([](StagedFiles &) {});
  EXPECT_EQ(entries_of(directory), 2U); // and what stands in the way
}

TEST_F(Staging, DirectoriesGoAsWell) {
  commit_fails([&](StagedFiles &staged) {
    staged.make_directory(directory + "/made/deep");
    staged.add(directory + "/made/deep/file", "text");
    write_durably(staged.add_directory(directory + "/whole") + "/file", "text", usual_permissions());
  });
  EXPECT_EQ(entries_of(directory), 2U);
}

TEST_F(Staging, NothingStaysOfWhatIsNotCommitted) {
  {
    StagedFiles staged;
    staged.make_directory(directory + "/made");
    staged.add(directory + "/made/file", "text");
  }
  EXPECT_EQ(entries_of(directory), 0U);
}

} // namespace
} // namespace symreal::program
