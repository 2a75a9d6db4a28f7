// File operations that have reached the disk when they return, and what a file's content is known by.
#pragma once

#include <string>

namespace symreal::program {

// All throw unwritable_output.
void write_durably(std::string const &path, std::string const &text, unsigned permissions);
void rename_durably(std::string const &from, std::string const &to);
void remove_durably(std::string const &path); // does nothing if it is not there

// SHA-256, in hexadecimal digits.
std::string content_hash(std::string const &text);
// Of the file; empty if it cannot be read.
std::string file_hash(std::string const &path);

} // namespace symreal::program
