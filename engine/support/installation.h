// Where the tools find what a symbolic program is compiled and linked with.
#pragma once

#include <string>

namespace symreal {

std::string const &runtime_include();    // the directory of symreal/real.h
std::string const &runtime_library();    // linked into a program that the tool runs
std::string const &generating_library(); // into one that is run by hand: the same, with the emitter
std::string const &recording_plugin();   // of clang, from rewrite/instrument/plugin.cpp

} // namespace symreal
