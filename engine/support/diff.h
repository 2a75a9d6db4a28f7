// Unified diff of two versions of a file.
#pragma once

#include <string>

namespace symreal {

// Output of `diff -u`, with the file name below a/ and b/; empty if the texts are equal. Throws unreadable_file if the
// program diff cannot run.
std::string unified_diff(std::string const &file, std::string const &before, std::string const &after);

} // namespace symreal
