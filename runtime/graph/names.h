// C identifiers for annotated objects.
#pragma once

#include "graph/graph.h"

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// One identifier per object, in order: the label without its array sections, other characters turned into '_', made
// different from each other and from C's and C++'s keywords. "c[0:3][0]" becomes c, "arm.q" arm_q.
std::vector<std::string> identifiers(std::vector<Object> const &objects);

// A member keeps its name where C and C++ have it.
std::vector<std::string> identifiers(std::vector<Member> const &members);

// Of C99 or C++: generated headers are for both.
bool is_keyword(std::string_view word);

// "q[2]", "m[1][0]", "x", "bodies[1].mass": how a person calls one element of an object.
std::string element_name(std::string const &identifier, Object const &object, std::uint32_t element);

} // namespace symreal
