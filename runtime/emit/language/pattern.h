// Patterns of text in the tables of languages: "$type $name = $value;" with the places filled.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace symreal {

// Replaces each $name, or ${name} before a letter, by its value. A name without a value is a fault of the table.
std::string fill(std::string_view pattern, std::initializer_list<std::pair<std::string_view, std::string_view>> values);

} // namespace symreal
