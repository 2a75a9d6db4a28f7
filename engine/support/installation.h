// The installed version of the tool, and paths of the files that a symbolic program is compiled and linked with.
#pragma once

#include <string>
#include <string_view>

namespace symreal {

inline constexpr std::string_view version = SYMREAL_VERSION;

std::string const &runtime_include();    // the directory of symreal/real.h
std::string const &runtime_library();    // linked into programs that the tool runs
std::string const &generating_library(); // linked into programs that the user runs: also has the emitter
std::string const &recording_plugin();   // clang plugin, from rewrite/instrument/plugin.cpp

} // namespace symreal
