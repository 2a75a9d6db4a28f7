#include "program/overlay.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace symreal;
namespace fs = std::filesystem;

namespace {

struct OverlayTest : testing::Test {
  fs::path directory = fs::path(testing::TempDir()) / "overlay-test";
  rewrite::Result result;

  OverlayTest() {
    //                                      columns: 1         11        21
    result.files.push_back({"/project/a.cpp",
                            "a.cpp",
                            "int n;\n  double x = 2.5, y;\n",
                            "int n;\n  REAL x = REAL_C(2.5), y;\n",
                            {{9, 6, "REAL"}, {20, 3, "REAL_C(2.5)"}}});
    result.include_dirs = {"/elsewhere", "/project"};
  }
  ~OverlayTest() override { fs::remove_all(directory); }
};

TEST_F(OverlayTest, ColumnsAreThoseOfTheOriginal) {
  program::Overlay overlay(result, directory.string());
  auto column = [&](unsigned line, unsigned rewritten) { return overlay.original({"a.cpp", line, rewritten}).column; };
  EXPECT_EQ(column(1, 5), 5u);
  EXPECT_EQ(column(2, 3), 3u);   // double
  EXPECT_EQ(column(2, 8), 10u);  // x
  EXPECT_EQ(column(2, 12), 14u); // the literal
  EXPECT_EQ(column(2, 25), 19u); // y, behind both edits
  EXPECT_EQ(overlay.original({"b.cpp", 2, 25}).column, 25u);
  EXPECT_EQ(overlay.original({"/project/a.cpp", 2, 8}).file, "a.cpp");
}

TEST_F(OverlayTest, OnlyDirectoriesWithRewrittenFilesAreSearched) {
  program::Overlay overlay(result, directory.string());
  EXPECT_EQ(overlay.include_flags(),
            (std::vector<std::string>{"-I", directory.string() + "/project", "-idirafter", "/project"}));
}

} // namespace
