// What a table can say of a language that is not like C: a made-up one, in the manner of Fortran.
#include "engine/emit/emit.h"
#include "engine/emit/language/language_file.h"
#include "engine/emit/language/pattern.h"
#include "engine/graph/graph_text.h"

#include <gtest/gtest.h>

namespace symreal {
namespace {

Language foreign(std::size_t width = 120) {
  std::string const table = R"toml(
comment = { open = "! ", next = "! " }
number = { name = "real(8)", zero = "0.0d0" }
truth = { name = "logical", zero = ".false." }
names = { keywords = ["end", "if", "real"], ignores_case = true }
numbers = { nan = "nan", negative_nan = "-nan", infinity = "inf", negative_infinity = "-inf", exponent = "d", suffix = "d0" }
files.extension = ".f90"
[expressions]
element = "$array($index)"
first_index = 1
yes = ".true."
truth_as_number = "merge(1.0d0, 0.0d0, $x)"
[expressions.operations]
pow = ["$x:15 ** $y:15", 14]
select = "merge($y, $z, $x)"
logical_and = ["$x:6 .and. $y:6", 5]
logical_not = [".not. $x:15", 14]
ne = ["$x:12 /= $y:12", 9]
[statements]
first_declaration = "$type :: $name"
variable = "$name = $value"
constant = "$name = $value"
set = "$name = $value"
array = "real(8) :: $name($count)"
open = "if ($condition) then"
otherwise = "else"
close = "end if"
[functions]
head = "subroutine $name($parameters)"
local_head = "subroutine $name($parameters)"
end = "end subroutine $name"
input = "$name"
output = "$name"
input_declaration = "real(8), intent(in) :: $name(*)"
output_declaration = "real(8), intent(out) :: $name(*)"
call = "call $name($arguments)"
most_statements = 3
[lines]
continuation = " &"
width = )toml" + std::to_string(width);
  Language language = read_language({"foreign.toml", table}, {}, {});
  language.name = "foreign";
  return language;
}

std::string compute_of(std::string const &nodes, std::size_t width = 120) {
  Graph const graph = read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\" [3]\noutput \"y\"\n"
                                 "%0 = input 0\n%1 = input 1\n%2 = input 2\n" +
                                     nodes,
                                 "test");
  std::string const text = emit(schedule(graph), foreign(width), {.base_name = "k"})[0].text;
  return text.substr(text.find("end subroutine preprocess\n\n") + 27);
}

TEST(Language, FunctionsDeclareFirstCountFromOneAndSpellTheirExceptions) {
  EXPECT_EQ(compute_of("%3 = pow %0 %1\n%4 = mul 2 %3\nresult 0 %4\n", 40), "subroutine compute(input, constants, &\n"
                                                                            "    output)\n"
                                                                            "  real(8), intent(in) :: input(*)\n"
                                                                            "  real(8), intent(in) :: constants(*)\n"
                                                                            "  real(8), intent(out) :: output(*)\n"
                                                                            "  real(8) :: t0\n"
                                                                            "  t0 = 2.0d0*input(1) ** input(2)\n"
                                                                            "  output(1) = t0\n"
                                                                            "end subroutine compute\n");
}

TEST(Language, TruthValuesAreNoNumbers) {
  std::string const text = compute_of("%3 = lt %0 %1\n%4 = add %3 %2\n%5 = logical_and %0 %3\n%6 = select %5 %4 1e300\n"
                                      "result 0 %6\n");
  EXPECT_NE(text.find("merge(1.0d0, 0.0d0, t0) + input(3)"), std::string::npos) << text;
  EXPECT_NE(text.find("(input(1) /= 0.0d0) .and. t0"), std::string::npos) << text;
  EXPECT_NE(text.find("1d+300"), std::string::npos) << text;
  EXPECT_NE(text.find("  logical :: t0\n"), std::string::npos) << text;
}

TEST(Language, BlocksHaveWordsForTheirEnds) {
  std::string const text = compute_of("%3 = lt %0 %1\n%4 = sqrt %0\n%5 = exp %4\n%6 = mul %4 %5\n%7 = select %3 %6 %2\n"
                                      "result 0 %7\n");
  EXPECT_NE(text.find("  if (t0) then\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  end if\n"), std::string::npos) << text;
  EXPECT_EQ(text.find(';'), std::string::npos) << text;
}

TEST(Language, NamesThatDifferInCaseAreOne) {
  std::string const text = compute_of("%3 = sin %0 \"Real\"\n%4 = cos %3 \"a\"\n%5 = mul %4 %3 \"A\"\n%6 = add %5 %4\n"
                                      "%7 = mul %6 %5\n%8 = add %7 %6\nresult 0 %8\n");
  EXPECT_NE(text.find("  Real_ = sin(input(1))\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  a = cos(Real_)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  A_ = a*Real_\n"), std::string::npos) << text;
}

TEST(Language, FunctionsAreCutAsTheTableSays) {
  std::string nodes;
  for (int k = 3; k < 10; ++k)
    nodes += "%" + std::to_string(k) + " = hypot %" + std::to_string(k - 1) + " %" + std::to_string(k - 2) + "\n";
  std::string const text = compute_of(nodes + "result 0 %9\n");
  EXPECT_NE(text.find("call compute_2(input, constants, v)"), std::string::npos) << text;
  EXPECT_NE(text.find("v(1) = "), std::string::npos) << text;
}

// What its table leaves out is told, and nothing is emitted.
void expect_refused(std::string const &lines, EmitOptions const &options, std::string const &what) {
  Graph const graph = read_graph("symreal-graph 1\nkernel \"k\"\ninput \"x\"\noutput \"y\"\n" + lines, "test");
  try {
    emit(schedule(graph), foreign(), options);
    ADD_FAILURE() << what;
  } catch (DiagnosticError const &error) {
    EXPECT_EQ(error.diagnostic().id, DiagnosticId::bad_option);
    EXPECT_EQ(error.diagnostic().message, what + ", which --lang=foreign does not have");
  }
}

TEST(Language, WhatItHasNotIsAnError) {
  expect_refused("table 0 \"t\" [2] = 1 2\n%0 = input 0\n%1 = lookup 0 %0\nresult 0 %1\n", {},
                 "kernel 'k' needs tables");
  expect_refused("external 0 \"f\" pure returns number takes number\n%0 = input 0\n%1 = argument 0 %0\n"
                 "%2 = call %1 0\n%3 = returned %2 0\nresult 0 %3\n",
                 {}, "kernel 'k' needs external functions");
  expect_refused("%0 = input 0\n%1 = wide_int %0\n%2 = wide_low %1\nresult 0 %2\n", {},
                 "kernel 'k' needs integers of 64 bits");
  expect_refused("%0 = input 0\n%1 = lt 0 %0\nresult 0 %0\nguard 0 %1 \"0 < x\"\n", {}, "kernel 'k' needs guards");
  expect_refused("%0 = input 0\nresult 0 %0\n", {.extras = {"mainline"}}, "--mainline needs a file of its own");
  expect_refused("%0 = input 0\nresult 0 %0\n", {.check_values = true}, "--debug=values needs reports of values");
}

TEST(Language, PatternsFillTheirPlaces) {
  EXPECT_EQ(Filling().set("type", "int").set("name", "t1").set("value", "3")("$type $name = ${value}u;"),
            "int t1 = 3u;");
}

// Faults of the files are told here first.
TEST(Language, EachRowHasATable) {
  for (auto const &[name, doc] : languages()) {
    Language const *const language = find_language(name);
    ASSERT_NE(language, nullptr);
    EXPECT_EQ(language->name, name);
    EXPECT_FALSE(doc.empty() || language->files.extension.empty()) << name;
    EXPECT_NE(language->functions.head.empty(), language->files.whole == nullptr) << name;
  }
  EXPECT_EQ(find_language("foreign"), nullptr);
}

} // namespace
} // namespace symreal
