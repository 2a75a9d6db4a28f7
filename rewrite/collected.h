// Collection stage of run(): the facts of the sources, before any decision on them.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

struct Collected {
  Facts facts;
  std::vector<std::string> left_out;  // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached; // if it asks for those that are reached
  std::size_t read = 0, kept = 0;     // sources, by Clang, and as an earlier run has read them
  std::map<std::string, double> reading_seconds;
};

// Throws DiagnosticError where a source cannot be read.
Collected collect(Request const &request);

} // namespace symreal::rewrite
