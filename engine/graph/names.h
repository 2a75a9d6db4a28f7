// Identifiers for annotated objects in the target languages.
#pragma once

#include "engine/graph/graph.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Naming rules of a language: its keywords, in ascending order, and its treatment of case.
struct NameRules {
  std::span<std::string_view const> keywords;
  bool ignores_case = false;
  bool has_underscores = true; // false: q_dot becomes qDot, and names begin with a small letter

  bool is_keyword(std::string_view word) const;
  // Comparison key: equal for names that the language does not distinguish.
  std::string key(std::string_view name) const;
  // Spelling of the name in the language.
  std::string spelled(std::string_view name) const;
};
// Keywords of C99 and C++, which share the generated headers.
extern NameRules const c_names;

// Whether the text has letters, digits and underscores only, and begins with no digit.
bool is_identifier(std::string_view name);

// A label without array sections, with '_' for other characters, distinct from keywords: "c[0:3][0]" becomes c, "arm.q"
// becomes arm_q.
std::string identifier(std::string const &label, NameRules const &rules = c_names);

// Distinct identifiers, one per object, in order.
std::vector<std::string> identifiers(std::vector<Object> const &objects, NameRules const &rules = c_names);

// Distinct identifiers of members; the same as their names if the language permits.
std::vector<std::string> identifiers(std::vector<Member> const &members, NameRules const &rules = c_names);

// Readable name of one element of an object: "q[2]", "m[1][0]", "x", "bodies[1].mass".
std::string element_name(std::string const &identifier, Object const &object, std::uint32_t element);
// Names of all elements, by slot.
std::vector<std::string> element_names(std::vector<Object> const &objects, NameRules const &rules = c_names);
// Name of the element at a slot; nullopt if the slot is beyond all objects.
std::optional<std::string> element_name(std::vector<Object> const &objects, std::uint32_t slot);

} // namespace symreal
