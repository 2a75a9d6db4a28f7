// A language as it is read from its files, and what is told of those that are wrong.
#include "engine/emit/language/language_file.h"

#include <gtest/gtest.h>

namespace symreal {
namespace {

std::string part(Emission const &) { return "part"; }
constexpr NamedCode code[] = {{"part", part}};

Language read(std::string_view table, std::string_view texts = {}) {
  static Language start;
  start.statements.set = "set $name";
  return read_language({"a.toml", table}, {"a.txt", texts}, code,
                       [](std::string_view name) -> Language const * { return name == "start" ? &start : nullptr; });
}

TEST(LanguageFile, TablesGiveFields) {
  Language const language = read(R"toml(
has_blocks = false # and a comment
comment = { open = "# ", close = '' }
lacks = ["fma"]
names.keywords = [
  "if", "end", # in any order
  "else",
]
["words"]
kind = ["c_double", "c_float"]
[expressions]
first_index = 1
element = '$array["$index"]'
[expressions.operations]
pow = ["$x:15 ** $y:15", 14]
select = "merge($y, $z, $x, $kind)"
[files]
begin = "part"
[files.companions]
always = { suffix = "\t\"\\\n" }
mainline = { text = "part", takes_doubles = true }
[module]
begin = '''

two
lines'''
)toml");
  EXPECT_FALSE(language.has_blocks);
  EXPECT_EQ(language.comment.open, "# ");
  EXPECT_EQ(language.lacks[0], Op::fma);
  EXPECT_EQ(std::vector(language.names.keywords.begin(), language.names.keywords.end()),
            (std::vector<std::string_view>{"else", "end", "if"}));
  EXPECT_EQ(language.words[0].in_single, "c_float");
  EXPECT_EQ(language.expressions.first_index, 1u);
  EXPECT_EQ(language.expressions.element, "$array[\"$index\"]");
  ASSERT_EQ(language.expressions.operations.size(), 2u);
  EXPECT_EQ(language.expressions.operations[0].precedence, 14);
  EXPECT_EQ(language.expressions.operations[1].op, Op::select);
  EXPECT_EQ(language.files.begin, part);
  EXPECT_EQ(language.files.companions[0].suffix, "\t\"\\\n");
  EXPECT_EQ(language.files.companions[0].option, "");
  EXPECT_EQ(language.files.companions[1].option, "mainline");
  EXPECT_EQ(language.files.companions[1].text, part);
  EXPECT_EQ(language.module.begin, "\ntwo\nlines");
  EXPECT_EQ(language.functions.most_statements, 500u);
}

TEST(LanguageFile, StartsFromAnotherLanguage) {
  Language const language = read("like = \"start\"\nstatements.open = \"if $condition\"\n");
  EXPECT_EQ(language.statements.set, "set $name");
  EXPECT_EQ(language.statements.open, "if $condition");
}

TEST(LanguageFile, TextsGiveHelpersAndLongPatterns) {
  Language const language = read("comment = { open = \"(* \", close = \" *)\" }\n", R"text((* What this is. *)

(* @declaration c_sin *)
c_sin: sin
(* @like c_sin c_cos c_tan *)

(* @helpers *)
one[x] is one
two

(* @helper many *)
many

lines


(* @text module.end *)
end $module
)text");
  std::vector<std::pair<std::string_view, std::string_view>> helpers;
  for (Helper const &helper : language.files.helpers) {
    helpers.emplace_back(helper.name, helper.text);
    EXPECT_EQ(helper.declares, helper.name.starts_with("c_"));
  }
  EXPECT_EQ(helpers, (decltype(helpers){{"c_sin", "c_sin: sin\n"},
                                        {"c_cos", "c_cos: cos\n"},
                                        {"c_tan", "c_tan: tan\n"},
                                        {"one", "one[x] is one\n"},
                                        {"two", "two\n"},
                                        {"many", "many\n\nlines\n\n"}}));
  EXPECT_EQ(language.module.end, "end $module\n");
}

TEST(LanguageFile, FaultsAreToldWithTheirLine) {
  struct Case {
    char const *table, *texts, *told;
  };
  std::string const usual = "comment.open = \"# \"\n";
  for (auto const &[table, texts, told] :
       {Case{"statements.sett = \"\"", "", "a.toml:2: there is no key 'statements.sett'"},
        {"[statements]\nset = \"$nmae\"", "", "a.toml:3: the pattern has no place $nmae: 'statements.set'"},
        {"statements.set = \"${name\"", "", "a.toml:2: the pattern has no place ${name: 'statements.set'"},
        {"statements.set = \"$Name\"", "", "a.toml:2: the pattern has no place $Name: 'statements.set'"},
        {"lines.width = \"wide\"", "", "a.toml:2: 'lines.width' takes a number"},
        {"has_blocks = 1", "", "a.toml:2: 'has_blocks' takes true or false"},
        {"lacks = \"fma\"", "", "a.toml:2: 'lacks' takes a list"},
        {"files.begin = \"parts\"", "", "a.toml:2: there is no function 'parts' for 'files.begin'"},
        {"expressions.operations.cosine = \"\"", "", "a.toml:2: there is no operation 'cosine'"},
        {"words.kind = [\"a\", \"b\", \"c\"]", "", "a.toml:2: 'words.kind' takes up to 2 values"},
        {"like = \"none\"", "", "a.toml:2: there is no such language"},
        {"like = \"a\"", "", "a.toml:2: a language cannot be like itself"},
        {"lines.width = 1.5", "", "a.toml:2: a value is a text, a whole number, true, false or a list of these"},
        {"[lines]\nwidth = 1\nwidth = 1", "", "a.toml:4: "}, // and what the library says of it
        {"files.extension = \".a", "", "a.toml:2: "},
        {"", "# @helpr a\n", "a.txt:1: there is no mark @helpr"},
        {"module.end = \"\"", "# @text module.end\n", "a.txt:1: 'module.end' is given twice"},
        {"", "# @like a b\n", "a.txt:1: @like names no helper above it"},
        {"", "\n# @text module.end\n$modul\n", "a.txt:2: the pattern has no place $modul: 'module.end'"}})
    try {
      read(usual + table, texts);
      ADD_FAILURE() << told;
    } catch (std::runtime_error const &error) {
      EXPECT_TRUE(std::string_view(error.what()).starts_with(told)) << error.what();
    }
}

} // namespace
} // namespace symreal
