// Reading and writing whole files.
#pragma once

#include <cstddef>
#include <string>

namespace symreal {

// Throws unreadable_file.
std::string read_file(std::string const &path);

// Writes all of it to an open file, however often the system breaks off. If it cannot, errno says why.
bool write_whole(int descriptor, void const *begin, std::size_t size);

// Writes to a temporary name in the same directory, then renames: a reader sees the old file or the new one. Leaves a
// file that already holds `text` untouched, so that its time stamp does not cause a rebuild. Throws unwritable_output.
void write_if_changed(std::string const &path, std::string const &text);

} // namespace symreal
