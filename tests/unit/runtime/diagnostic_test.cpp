#include "engine/diagnostics/diagnostic.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

using namespace symreal;

TEST(Diagnostics, EveryRowIsCompleteAndItsNumberUnique) {
  std::set<std::string> codes;
  for (DiagnosticInfo const &row : diagnostic_table()) {
    EXPECT_TRUE(codes.insert(code(row.id)).second) << row.name;
    EXPECT_EQ(code(row.id).size(), 6u) << row.name;
    EXPECT_FALSE(row.summary.empty()) << row.name;
    EXPECT_FALSE(row.explanation.empty()) << row.name;
    EXPECT_FALSE(row.help.empty()) << row.name;
    EXPECT_EQ(find_diagnostic(code(row.id)), &row) << row.name;
  }
}

TEST(Diagnostics, PrintedFormHasPlaceSeverityTextAndId) {
  std::ostringstream out;
  print(out, {DiagnosticId::bad_option, {"a.cpp", 3, 7}, "text", {{{"b.h", 1, 0}, "seen here"}}, Severity::warning});
  EXPECT_EQ(out.str().substr(0, out.str().find("  help")),
            "a.cpp:3:7: warning: text [SYM003]\nb.h:1: note: seen here\n");
}
