// Text that takes the place of a kernel's function, as a file of its own or as statements in a copy of its file: it
// packs the arguments, calls the generated code and unpacks the results.
#pragma once

#include "program/record/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace symreal::tool {

// Throws no_wrapper for a kernel whose place no function can take.
void require_replaceable(rewrite::Kernel const &kernel);

std::filesystem::path real_path(std::filesystem::path const &path);
// Path relative to the wrapper's directory; absolute if they share only the root.
std::string path_from(std::filesystem::path const &directory, std::filesystem::path const &file);

// Declarations of the generated functions without parameter names, which may be macros of the program.
std::string c_declarations(Graph const &graph, std::string const &prefix);

// Blocks of text before the function, common to both forms.
std::vector<std::string> preamble(program::Recorded const &recorded, Graph const &graph, std::string const &prefix);

// A file that defines the function.
std::string own_file(program::Recorded const &recorded, Graph const &graph, std::string const &prefix,
                     std::filesystem::path const &directory);

// Statements before the body in a copy; the body is the fallback.
std::string try_statements(program::Recorded const &recorded, Graph const &graph, std::string const &prefix);

} // namespace symreal::tool
