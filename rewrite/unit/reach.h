// Call graph from a function of the sources, across sources: the functions that it calls, their callees, and the
// variables that outlive a call which these read and write. It is computed from the text, before anything is built.
//
// Direct calls are followed, calls of virtual functions to all overriders in the sources. Callees behind a pointer are
// unknown.
#pragma once

#include "rewrite/request/request.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

// A variable of static storage duration that is not constant.
struct ReachedState {
  std::string name;                              // source name
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
  std::vector<std::string> undefined;     // callees without a definition in the sources, except the system's
};

// The union for all functions with this name, qualified or not. Throws unknown_kernel if no source defines one. Sources
// that do not compile count as far as they can be read.
Reach reach_of(std::string const &function, Request const &request);

} // namespace symreal::rewrite
