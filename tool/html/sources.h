// The sources that a graph names: their text, and which function a line stands in.
#pragma once

#include "engine/graph/graph.h"
#include "tool/html/functions.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

struct SourceFile {
  std::string name;
  std::optional<std::string> text; // none: it is gone
  std::vector<FunctionLines> functions;
};

class Sources {
public:
  // The files of the user's own places: those of operations, guards and baked-in state.
  explicit Sources(Graph const &graph);

  std::vector<SourceFile> const &files() const { return files_; }
  // Among the files; nothing if it is none of them.
  std::optional<std::size_t> number_of(std::string const &file) const;
  // Empty where the line stands in no function, or its text is gone.
  std::string function_at(std::size_t file, unsigned line) const;

private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<SourceFile> files_;
};

// A warning for each source that is gone.
std::vector<Diagnostic> gone_sources(Sources const &sources);

} // namespace symreal::tool
