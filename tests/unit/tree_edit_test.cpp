#include "program/build/tree_edit.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/workspace.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace {

using namespace symreal;
namespace fs = std::filesystem;

struct TreeEditTest : testing::Test {
  program::Workspace const workspace{false};
  std::string const directory = fs::canonical(workspace.path()).string();
  std::string const one = directory + "/one", two = directory + "/two";

  TreeEditTest() {
    write_if_changed(one, "1");
    write_if_changed(two, "2");
  }

  DiagnosticId refusal(std::vector<program::Replacement> const &replacements) {
    try {
      program::edit_tree(replacements);
    } catch (DiagnosticError const &error) {
      return error.diagnostic().id;
    }
    return {};
  }
};

TEST_F(TreeEditTest, ReplacesAllAndBringsBackAll) {
  EXPECT_EQ(program::edit_tree({{one, "1", "eins"}, {two, "2", "zwei"}}), directory);
  EXPECT_EQ(read_file(one) + read_file(two), "einszwei");
  EXPECT_EQ(program::undo_tree(directory).size(), 2U);
  EXPECT_EQ(read_file(one) + read_file(two), "12");
  EXPECT_FALSE(fs::exists(directory + "/.symreal"));
}

TEST_F(TreeEditTest, UndoesOneEditAfterAnother) {
  program::edit_tree({{one, "1", "eins"}});
  program::edit_tree({{one, "eins", "un"}, {two, "2", "deux"}});
  program::undo_tree(directory);
  EXPECT_EQ(read_file(one) + read_file(two), "eins2");
  program::undo_tree(directory);
  EXPECT_EQ(read_file(one) + read_file(two), "12");
}

TEST_F(TreeEditTest, RefusesAFileThatChangedMeanwhile) {
  EXPECT_EQ(refusal({{one, "1", "eins"}, {two, "another text", "zwei"}}), DiagnosticId::changed_file);
  EXPECT_EQ(read_file(one) + read_file(two), "12");
  EXPECT_FALSE(fs::exists(directory + "/.symreal"));
}

TEST_F(TreeEditTest, KeepsThePermissionsOfAFile) {
  fs::permissions(one, fs::perms::owner_all);
  program::edit_tree({{one, "1", "eins"}});
  EXPECT_EQ(fs::status(one).permissions(), fs::perms::owner_all);
}

TEST_F(TreeEditTest, NothingToDoLeavesNothing) {
  program::edit_tree({});
  EXPECT_EQ(program::recover_tree(directory), program::Recovery::nothing);
  EXPECT_THROW(program::undo_tree(directory), DiagnosticError);
  EXPECT_FALSE(fs::exists(directory + "/.symreal"));
}

} // namespace
