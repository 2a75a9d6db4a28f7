// The first lines of a generated file. By the very first a tool recognises it as its own: a comment "symreal {...}"
// with JSON. A line of its own names the mathematical library of the original.
#pragma once

#include <string>
#include <string_view>

namespace symreal {

// The JSON in the first line of a generated file, in whatever language; empty where the text begins otherwise.
std::string_view banner_of(std::string_view text);

// The line that names the library, without the marks of a comment.
std::string reference_line(std::string const &library);

// The library in that line of a generated file; empty where the file has no such line.
std::string_view reference_of(std::string_view text);

// The text without that line: what differs is then no matter of the machine's name.
std::string without_reference(std::string text);

// Throws unwritable_output where generated text would replace a file that is not generated: a function `step` of a
// kernel may well stand in a step.c.
void require_ours(std::string const &path, std::string const &text);

} // namespace symreal
