// The first lines of a generated file, by which a tool recognises it as its own.
#pragma once

#include <string>

namespace symreal {

// Throws unwritable_output where generated text would replace a file that is not generated: a function `step` of a
// kernel may well stand in a step.c.
void require_ours(std::string const &path, std::string const &text);

} // namespace symreal
