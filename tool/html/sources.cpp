#include "tool/html/sources.h"

#include "engine/support/files.h"

#include <algorithm>

namespace symreal::tool {

static std::optional<std::string> text_of(std::string const &file) {
  try {
    return read_file(file);
  } catch (DiagnosticError const &) {
    return {};
  }
}

Sources::Sources(Graph const &graph) {
  for (Location const &location : graph.locations)
    if (!location.places.empty()) numbers_[location.places.front().file];
  for (Frozen const &state : graph.frozen)
    if (!state.place.file.empty()) numbers_[state.place.file];
  for (auto &[name, number] : numbers_) {
    number = files_.size();
    files_.push_back({name, text_of(name), {}});
    auto &file = files_.back();
    if (file.text) file.functions = function_lines(*file.text);
  }
}

std::optional<std::size_t> Sources::number_of(std::string const &file) const {
  auto const found = numbers_.find(file);
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::string Sources::function_at(std::size_t file, unsigned line) const {
  std::vector<FunctionLines> const &functions = files_[file].functions;
  auto const next = std::ranges::upper_bound(functions, line, {}, &FunctionLines::first);
  return next != functions.begin() && std::prev(next)->last >= line ? std::prev(next)->name : std::string();
}

std::vector<Diagnostic> gone_sources(Sources const &sources) {
  std::vector<Diagnostic> warnings;
  for (SourceFile const &file : sources.files())
    if (!file.text)
      warnings.push_back({DiagnosticId::source_gone, {file.name}, "the report is without the text of this source"});
  return warnings;
}

} // namespace symreal::tool
