// The first line of a generated file, by which a tool recognises it as its own: a comment "symreal {...}" with JSON.
#pragma once

#include <string>
#include <string_view>

namespace symreal {

// The JSON in the first line of a generated file, in whatever language; empty where the text begins otherwise.
std::string_view banner_of(std::string_view text);

// Throws unwritable_output where generated text would replace a file that is not generated: a function `step` of a
// kernel may well stand in a step.c.
void require_ours(std::string const &path, std::string const &text);

} // namespace symreal
