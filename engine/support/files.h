// Reading and writing whole files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symreal {

// Throws unreadable_file.
std::string read_file(std::string const &path);

// Calls `watch` with the path of each file that read_file reads from now on: a command notes its inputs by this. To be
// set before there are threads.
void watch_reads(void (*watch)(std::string const &path));

// The text of a file, read without notice to the watch: of a result of an earlier run, which a new one replaces.
// Nothing if it cannot be read.
std::optional<std::string> text_of_file(std::string const &path);

// Whether the file holds this text.
bool holds(std::string const &path, std::string_view text);

// Writes all of it to an open file, however often the system breaks off. If it cannot, errno says why.
bool write_whole(int descriptor, void const *begin, std::size_t size);

// Writes to a temporary name in the same directory, then renames: a reader sees the old file or the new one. Leaves a
// file that already holds `text` untouched, so that its time stamp does not cause a rebuild. Throws unwritable_output.
void write_if_changed(std::string const &path, std::string const &text);

} // namespace symreal
