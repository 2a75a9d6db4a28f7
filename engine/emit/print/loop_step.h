// Printing of one step of a loop program.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"
#include "engine/emit/print/loop_tables.h"

#include <string>

namespace symreal {

// Names of the arrays of a function.
struct LoopArrays {
  std::string given, read, memory, filled, sine, cosine;
  bool may_be_constant = false; // whether memory is constant on some path
};

// Prints into `out`, with the tables that only this step reads; adds the names of the arrays in the text to `used`.
void print_step(Emission &emission, reroll::Step const &step, StepNumbers const &numbers, LoopTables const &tables,
                LoopArrays const &arrays, CodeText &out, std::set<std::string> &used);

} // namespace symreal
