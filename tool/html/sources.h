// Source files that a graph names, with their text and functions.
#pragma once

#include "engine/graph/graph.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

// Function of C or C++ source, which the graph lacks, as far as the text tells.
struct FunctionLines {
  std::string name; // "dot", "Robot::inverse"
  unsigned first, last;
};

struct SourceFile {
  std::string name;
  std::optional<std::string> text; // nullopt if the file is missing
  std::vector<FunctionLines> functions;
};

class Sources {
public:
  // Files of the user's own places: of operations, guards and baked-in state.
  explicit Sources(Graph const &graph);

  std::vector<SourceFile> const &files() const { return files_; }
  // Index of the file; nullopt if it is not among them.
  std::optional<std::size_t> number_of(std::string const &file) const;
  // Function at the line; empty outside functions or if the text is missing.
  std::string function_at(std::size_t file, unsigned line) const;

private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<SourceFile> files_;
};

// One warning for each missing source.
std::vector<Diagnostic> gone_sources(Sources const &sources);

} // namespace symreal::tool
