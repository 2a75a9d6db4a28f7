#include "engine/emit/language/pattern.h"
#include "engine/emit/languages/languages.h"

#include <gtest/gtest.h>

namespace symreal {

TEST(PreparedPattern, IsFilledInAsTheSamePatternIs) {
  Language const &language = *find_language("c");
  for (std::string const pattern : {"$type const $name = $value;", "${name}$value", "$name", "text", "$$$name", ""}) {
    PreparedPattern const prepared(language, pattern, {"type", "name", "value"});
    std::string text = "before ";
    prepared.append_to(text, {"bool", "x", "1 $name"});
    EXPECT_EQ(text, "before " + fill(language, pattern, {{"type", "bool"}, {"name", "x"}, {"value", "1 $name"}}));
  }
}

TEST(PreparedPattern, HasTheWordsOfTheLanguage) {
  PreparedPattern const prepared(*find_language("c"), "$real $name[$count];", {"name", "count"});
  std::string text;
  prepared.append_to(text, {"v", "3"});
  EXPECT_EQ(text, "double v[3];");
}

} // namespace symreal
