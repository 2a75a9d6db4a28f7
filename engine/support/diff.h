// Two texts of one file, as people compare them.
#pragma once

#include <string>

namespace symreal {

// `diff -u`, with the file's name below a/ and b/; empty where the texts are the same. Throws unreadable_file where the
// program diff cannot run.
std::string unified_diff(std::string const &file, std::string const &before, std::string const &after);

} // namespace symreal
