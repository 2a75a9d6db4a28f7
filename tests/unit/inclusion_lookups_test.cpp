#include "program/build/compiled_from.h"

#include <gtest/gtest.h>

namespace symreal::program {
namespace {

using All = std::vector<Inclusion>;

std::optional<All> names_in(std::string_view text) {
  std::optional<Inclusions> const found = inclusions_of(text);
  return found ? std::optional(found->names) : std::nullopt;
}

TEST(InclusionLookups, finds_what_is_included_or_asked_for) {
  EXPECT_EQ(names_in("int i;\n// This file is to be #include d by others.\n/*\n #include's protect themselves */"),
            All());
  EXPECT_EQ(names_in("#include <a.h>\n # include_next\t\"b.h\"\n#import <c>"),
            (All{{"a.h", false}, {"b.h", true}, {"c", false}}));
  EXPECT_EQ(names_in("/* one */ #include <a.h>\n%:include \"b.h\"\n"), (All{{"a.h", false}, {"b.h", true}}));
  EXPECT_EQ(names_in("#if __has_include(<a.h>) && __has_include_next ( \"b.h\" )\n"),
            (All{{"a.h", false}, {"b.h", true}}));
}

TEST(InclusionLookups, takes_a_question_for_the_question_for_no_file) {
  EXPECT_EQ(names_in("#ifdef __has_include\n#if defined(__has_include) && X\n"), All());
}

TEST(InclusionLookups, names_each_once) {
  EXPECT_EQ(names_in("#include <a.h>\n#include <a.h>\n"), (All{{"a.h", false}}));
}

TEST(InclusionLookups, gives_up_on_what_it_cannot_tell) {
  for (char const *text :
       {"#include HEADER(a)\n", "#if __has_include(HEADER)\n", "#include \\\n<a.h>\n", "# \\\n include <a.h>\n",
        "#/**/include <a.h>\n", "#include <a.h\n", "char const *day = __DATE__;\n"})
    EXPECT_EQ(names_in(text), std::nullopt) << text;
}

TEST(InclusionLookups, tells_by_which_macros_a_text_includes) {
  EXPECT_EQ(inclusions_of("# include PLUGIN \n#include <a.h>\n")->macros, std::vector<std::string>{"PLUGIN"});
  EXPECT_TRUE(defines("#define PLUGIN \"a.h\"", "PLUGIN"));
  EXPECT_TRUE(defines("# define  \\\n PLUGIN", "PLUGIN"));
  EXPECT_FALSE(defines("#ifdef PLUGIN\n#define PLUGINS 1\n#define MY_PLUGIN", "PLUGIN"));
}

TEST(InclusionLookups, reads_the_list_of_directories) {
  EXPECT_EQ(searched_directories("Using built-in specs.\n"
                                 "ignoring nonexistent directory \"/usr/local/include/x86_64-linux-gnu\"\n"
                                 "#include \"...\" search starts here:\n"
                                 " quoted\n"
                                 "#include <...> search starts here:\n"
                                 " inc\n"
                                 " /usr/include\n"
                                 "End of search list.\n"
                                 " not this\n"),
            (std::vector<std::string>{"/usr/local/include/x86_64-linux-gnu", "quoted", "inc", "/usr/include"}));
}

} // namespace
} // namespace symreal::program
