// The parts of the C output, one function each. Shared by emit_c only.
#pragma once

#include "emit/print/emitted.h"
#include "emit/print/words.h"
#include "schedule/schedule.h"

namespace symreal {

// What verification and people need to know of a generated file: the first lines of source and header. One line is
// JSON, so that a tool can recognise the file as its own.
std::string c_banner(Schedule const &plan, EmitOptions const &options);

std::string c_source(Schedule const &plan, EmitOptions const &options);
std::string c_header(Schedule const &plan, EmitOptions const &options);
std::string c_mainline(Schedule const &plan, EmitOptions const &options);

// With guards only: the list of them, for the header, and the function that gives their texts.
std::string c_guard_list(Schedule const &plan, EmitOptions const &options);
std::string c_guard_text(Schedule const &plan, EmitOptions const &options);

// A comment for the header that lists the state that is baked in; empty where none is.
std::string c_frozen_list(Graph const &graph);

} // namespace symreal
