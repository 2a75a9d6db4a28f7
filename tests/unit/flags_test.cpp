#include "program/build/compile.h"

#include <gtest/gtest.h>

using namespace symreal::program;
using Flags = std::vector<std::string>;

TEST(Flags, WhatChangesTheNumbersOrChoosesOutputsIsDropped) {
  EXPECT_EQ(adapted_flags({"-O3", "-ffast-math", "-Ofast", "-Wall", "-Werror", "-c", "-o", "a.o", "-MD", "-MF", "a.d"}),
            Flags{"-std=c++20"});
  EXPECT_EQ(adapted_flags({"-Iinc", "-DX=1", "-include", "a.h", "-Wl,-rpath,x"}),
            (Flags{"-Iinc", "-DX=1", "-include", "a.h", "-Wl,-rpath,x", "-std=c++20"}));
}

TEST(Flags, TheStandardIsAtLeastTheOneTheHeadersNeed) {
  EXPECT_EQ(adapted_flags({"-std=c99"}), Flags{"-std=c++20"});
  EXPECT_EQ(adapted_flags({"-std=gnu++14"}), Flags{"-std=gnu++20"});
  EXPECT_EQ(adapted_flags({"-std=c++23"}), Flags{"-std=c++23"});
}

TEST(Flags, TheOriginalKeepsItsStandard) {
  EXPECT_EQ(original_flags({"-std=c89", "-O3", "-Wall"}, Variant::original), Flags{"-std=c89"});
  EXPECT_EQ(original_flags({"-Iinc"}, Variant::original), Flags{"-Iinc"});
  EXPECT_EQ(original_flags({"-std=gnu++98"}, Variant::original), Flags{"-std=gnu++11"});
}

TEST(Flags, TheUsersOwnBuildKeepsWhatChangesTheNumbers) {
  EXPECT_EQ(original_flags({"-O3", "-ffast-math", "-fopenmp", "-Wall"}, Variant::own_flags),
            (Flags{"-O3", "-ffast-math"}));
  EXPECT_EQ(flags_of_numbers({"-O2", "-Wall", "-march=native"}), (std::vector<std::string>{"-O2", "-march=native"}));
  EXPECT_TRUE(flags_of_numbers({"-Iinc", "-Wall", "-std=c++17"}).empty());
}
