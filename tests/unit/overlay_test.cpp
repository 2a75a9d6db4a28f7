#include "program/build/overlay.h"
#include "program/build/workspace.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace symreal;
namespace fs = std::filesystem;

namespace {

struct OverlayTest : testing::Test {
  program::Workspace const workspace{false};
  fs::path const directory = workspace.path();
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

TEST_F(OverlayTest, DirectoriesAreSearchedInTheirOrder) {
  std::string const top = directory.string(), names = "-ffile-prefix-map=" + top + "=";
  program::Overlay overlay(result, top);
  EXPECT_EQ(overlay.search_flags({"-I/elsewhere", "-Iproject", "-Dx"}, "/"),
            (std::vector<std::string>{"-I", "/elsewhere", "-I", top + "/project", "-I", "project", "-Dx", names}));
  EXPECT_EQ(overlay.search_flags({}), (std::vector<std::string>{"-I", top + "/project", names}));
}

TEST_F(OverlayTest, WhatStandsBesideARewrittenFileIsFoundThere) {
  fs::path const project = directory / "real", top = directory / "overlay";
  fs::create_directories(project / "detail");
  std::ofstream(project / "excluded.h") << "int n;\n";
  result.files[0].path = (project / "a.cpp").string();
  program::Overlay overlay(result, top.string());
  fs::path const mirror = top.string() + project.string();
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(mirror / "a.cpp")));
  EXPECT_EQ(fs::read_symlink(mirror / "excluded.h"), project / "excluded.h");
  EXPECT_EQ(fs::read_symlink(mirror / "detail"), project / "detail");
}

} // namespace
