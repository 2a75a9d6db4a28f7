// Reading, writing and comparing whole files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symreal {

// Throws unreadable_file.
std::string read_file(std::string const &path);

// Calls `watch` with the path of each file that read_file reads from now on, so that a command can note its inputs.
// Must be set before threads start.
void watch_reads(void (*watch)(std::string const &path));

// The text of a file, hidden from the watch: for the result of an earlier run that a new one replaces. Nullopt if it
// cannot be read.
std::optional<std::string> text_of_file(std::string const &path);

// Whether the file has exactly this text.
bool holds(std::string const &path, std::string_view text);

// Writes all bytes to an open file, resuming interrupted writes. False on failure, with errno set.
bool write_whole(int descriptor, void const *begin, std::size_t size);

// Writes to a temporary name in the same directory, then renames: a reader sees the old file or the new one. Leaves a
// file that already holds `text` untouched, so that its time stamp does not cause a rebuild. Throws unwritable_output.
void write_if_changed(std::string const &path, std::string const &text);

// Output of `diff -u`, with the file name below a/ and b/; empty if the texts are equal. Throws unreadable_file if the
// program diff cannot run.
std::string unified_diff(std::string const &file, std::string const &before, std::string const &after);

} // namespace symreal
