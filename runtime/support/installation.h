// Where the tools find what a symbolic program is compiled and linked with.
#pragma once

#include <string>

namespace symreal {

std::string const &runtime_include();  // the directory of symreal/real.h
std::string const &runtime_library();  // the file
std::string const &recording_plugin(); // of clang, from oracle/plugin.cpp

} // namespace symreal
