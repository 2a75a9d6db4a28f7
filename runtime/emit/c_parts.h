// The parts of the C output, one function each. Shared by emit_c only.
#pragma once

#include "emit/emit.h"
#include "schedule/program.h"

namespace symreal {

// What verification and people need to know of a generated file: the first lines of source and header. One line is
// JSON, so that a tool can recognise the file as its own.
std::string c_banner(Program const &program, EmitOptions const &options);

std::string c_source(Program const &program, EmitOptions const &options);
std::string c_header(Program const &program, EmitOptions const &options);
std::string c_mainline(Program const &program, EmitOptions const &options);

// With guards only: the list of them, for the header, and the function that gives their texts.
std::string c_guard_list(Program const &program, EmitOptions const &options);
std::string c_guard_text(Program const &program, EmitOptions const &options);

// A comment for the header that lists the state that is baked in; empty where none is.
std::string c_frozen_list(Graph const &graph);

// Neither the end of a comment nor its beginning.
std::string in_comment(std::string const &text);

// A file outside of the project (Eigen, std) stands somewhere else on every machine.
std::string portable_place(Place place);

// "arm_" + name, or the bare name.
std::string prefixed(EmitOptions const &options, std::string const &name);

} // namespace symreal
