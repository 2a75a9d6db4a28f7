// Tests of one program run in processes side by side.
#pragma once

#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace symreal::test {

// A path that no other process has.
inline std::string own_file(std::string const &name) {
  return testing::TempDir() + name + "-" + std::to_string(getpid());
}

} // namespace symreal::test
