#include "tool/compiler/dependencies.h"

#include "program/build/make_rule.h"

#include <filesystem>

namespace symreal::compiler {

namespace fs = std::filesystem;

DependencyOptions completed(CommandLine const &line, std::string const &source) {
  DependencyOptions options = line.dependencies;
  fs::path const stem = fs::path(source).stem();
  bool const names_object = line.action != Action::link && !line.output.empty();
  if (options.targets.empty())
    options.targets.push_back(program::make_escaped(names_object ? line.output : stem.string() + ".o"));
  if (!options.file.empty()) return options;
  if (line.action == Action::link)
    options.file = (line.output.empty() ? "a" : line.output) + "-" + stem.string() + ".d";
  else
    options.file = names_object ? fs::path(line.output).replace_extension(".d").string() : stem.string() + ".d";
  return options;
}

std::string write_dependencies(DependencyOptions const &options, Words const &names) {
  return program::make_rule(options.targets, names,
                            options.phony ? program::Phony::all_but_first : program::Phony::none);
}

} // namespace symreal::compiler
