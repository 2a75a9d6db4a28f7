// What a function of the sources reaches, from source to source: the functions that it calls, their callees, and the
// variables that outlive a call which these read and write. It is told from the text, before anything is built.
//
// Direct calls are followed, calls of virtual functions to all overriders in the sources. What is called through a
// pointer is not known from the text.
#pragma once

#include "rewrite/request/request.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

// A variable of static storage duration that is not constant.
struct ReachedState {
  std::string name;                              // as the source has it
  Place place;                                   // of its definition, or of a declaration
  bool is_written = false, is_passed_on = false; // its address leaves the expression
};

struct ReachedFunction {
  std::string name;
  Place begin, end; // of its definition
};

struct Reach {
  std::vector<ReachedFunction> functions; // those that the sources define, by place
  std::vector<ReachedState> state;        // by place
  std::vector<Note> not_followed;         // calls through pointers
  std::vector<std::string> undefined;     // called, and defined in no source; those of the system are left out
};

// Of all functions with this name, qualified or not. Throws unknown_kernel where no source defines one. Sources that do
// not compile count as far as they can be read.
Reach reach_of(std::string const &function, Request const &request);

} // namespace symreal::rewrite
