// Banner: the first lines of a generated file. The very first, a comment "symreal {...}" with JSON, lets a tool
// recognise the file as its own. Another line names the mathematical library of the original.
#pragma once

#include <string>
#include <string_view>

namespace symreal {

// JSON in the first line of a generated file of any language; empty if the text begins otherwise.
std::string_view banner_of(std::string_view text);

// The line that names the library, without comment marks.
std::string reference_line(std::string const &library);

// The library that the line of a generated file names; empty if the file lacks the line.
std::string_view reference_of(std::string_view text);

// The text without that line, for comparison across machines.
std::string without_reference(std::string text);

// Throws unwritable_output if generated text would replace a file of other origin: the user may have a step.c beside a
// kernel `step`.
void require_ours(std::string const &path, std::string const &text);

} // namespace symreal
