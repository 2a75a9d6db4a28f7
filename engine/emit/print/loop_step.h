// The statements of a step of a function of loops.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"
#include "engine/emit/print/loop_tables.h"

#include <string>

namespace symreal {

// What the arrays of a function are called.
struct LoopArrays {
  std::string given, read, memory, filled, sine, cosine;
  bool may_be_constant = false; // what stands in memory, on some path
};

// Prints into `out`, with the tables that no other step reads; the names of the arrays that the text has are added to
// `used`.
void print_step(Emission &emission, reroll::Step const &step, StepNumbers const &numbers, LoopTables const &tables,
                LoopArrays const &arrays, CodeText &out, std::set<std::string> &used);

} // namespace symreal
