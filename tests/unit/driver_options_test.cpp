#include "rewrite/request/driver_options.h"

#include <gtest/gtest.h>

namespace symreal::rewrite {
namespace {

using Words = std::vector<std::string>;

TEST(DriverOptions, OperandsStandInTheSameWordOrInTheNext) {
  for (Words const &words : {Words{"-I", "include"}, Words{"-Iinclude"}}) {
    std::vector<DriverOption> const options = driver_options(words);
    ASSERT_EQ(options.size(), 1u);
    EXPECT_EQ(options[0].about, About::directories);
    EXPECT_EQ(options[0].name, "-I");
    EXPECT_EQ(options[0].value, "include");
    EXPECT_EQ(options[0].length, words.size());
  }
}

TEST(DriverOptions, EachIsAboutSomething) {
  struct Case {
    Words words;
    About about;
  };
  for (Case const &one : {Case{{"a.cpp"}, About::input},
                          Case{{"-"}, About::input},
                          Case{{"-o", "a"}, About::output},
                          Case{{"-oa"}, About::output},
                          Case{{"-c"}, About::action},
                          Case{{"-fsyntax-only"}, About::action},
                          Case{{"-MD"}, About::dependencies},
                          Case{{"-MF", "a.d"}, About::dependencies},
                          Case{{"-MTa.o"}, About::dependencies},
                          Case{{"-MM"}, About::question},
                          Case{{"--version"}, About::question},
                          Case{{"-print-search-dirs"}, About::question},
                          Case{{"-xc"}, About::language},
                          Case{{"-x", "c++"}, About::language},
                          Case{{"-std=c++17"}, About::standard},
                          Case{{"--std=gnu11"}, About::standard},
                          Case{{"-ansi"}, About::standard},
                          Case{{"-O2"}, About::numbers},
                          Case{{"-Ofast"}, About::numbers},
                          Case{{"-O"}, About::numbers},
                          Case{{"-ffast-math"}, About::numbers},
                          Case{{"-ffp-contract=fast"}, About::numbers},
                          Case{{"-fno-fast-math"}, About::other},
                          Case{{"-march=native"}, About::machine},
                          Case{{"-mavx2"}, About::machine},
                          Case{{"-mllvm", "-x"}, About::other},
                          Case{{"-fopenmp=libomp"}, About::openmp},
                          Case{{"-flto=auto"}, About::link_time},
                          Case{{"-flto-partition=none"}, About::link_time},
                          Case{{"-Wall"}, About::warnings},
                          Case{{"-Wduplicated-cond"}, About::warnings}, // of gcc alone
                          Case{{"-Werror=vla"}, About::warnings},
                          Case{{"-pedantic-errors"}, About::warnings},
                          Case{{"-Wl,-z,now"}, About::linking},
                          Case{{"-Wp,-MD,a.d"}, About::other},
                          Case{{"-lm"}, About::linking},
                          Case{{"-fsanitize=address"}, About::sanitizers},
                          Case{{"-include", "a.h"}, About::headers},
                          Case{{"-isystem/usr"}, About::directories},
                          Case{{"-D", "A=1"}, About::other},
                          Case{{"-aux-info", "a"}, About::other}, // of gcc alone
                          Case{{"-fno-such-option"}, About::other}}) {
    std::vector<DriverOption> const options = driver_options(one.words);
    ASSERT_EQ(options.size(), 1u) << one.words[0];
    EXPECT_EQ(options[0].about, one.about) << one.words[0];
    EXPECT_EQ(options[0].length, one.words.size()) << one.words[0];
  }
}

TEST(DriverOptions, WordsAreLeftOutWithTheirOperands) {
  Words const words = {"-c", "-o", "a.o", "-MF", "a.d", "-DX", "-O2", "a.cpp", "-I", "-o"};
  EXPECT_EQ(without(words, {About::action, About::output, About::dependencies}),
            (Words{"-DX", "-O2", "a.cpp", "-I", "-o"}));
  EXPECT_EQ(without({"-DX", "-I"}, {About::numbers}), (Words{"-DX", "-I"})); // an operand is missing
}

} // namespace
} // namespace symreal::rewrite
