// Identifiers for annotated objects.
#pragma once

#include "engine/graph/graph.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// What a language says of names: the words that are none, in ascending order, and whether Ab and aB are one.
struct NameRules {
  std::span<std::string_view const> keywords;
  bool ignores_case = false;
  bool has_underscores = true; // otherwise q_dot is qDot, and names begin with a small letter

  bool is_keyword(std::string_view word) const;
  // Equal for names that are one.
  std::string key(std::string_view name) const;
  // The name as the language writes it.
  std::string spelled(std::string_view name) const;
};
// The keywords of C99 and of C++: generated headers are for both.
extern NameRules const c_names;

// A label without its array sections, other characters turned into '_', and no keyword: "c[0:3][0]" becomes c, "arm.q"
// arm_q.
std::string identifier(std::string const &label, NameRules const &rules = c_names);

// One per object, in order, made different from each other.
std::vector<std::string> identifiers(std::vector<Object> const &objects, NameRules const &rules = c_names);

// A member keeps its name where the language has it.
std::vector<std::string> identifiers(std::vector<Member> const &members, NameRules const &rules = c_names);

// "q[2]", "m[1][0]", "x", "bodies[1].mass": how a person calls one element of an object.
std::string element_name(std::string const &identifier, Object const &object, std::uint32_t element);
// Of all elements, slot by slot.
std::vector<std::string> element_names(std::vector<Object> const &objects, NameRules const &rules = c_names);
// That of the slot; nothing where no object has it.
std::optional<std::string> element_name(std::vector<Object> const &objects, std::uint32_t slot);

} // namespace symreal
