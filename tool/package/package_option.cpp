#include "tool/package/package_option.h"

#include "tool/output/folder.h"

#include <filesystem>

namespace symreal::tool {

void PackageOption::add_to(CLI::App &app) {
  app.add_option("--package", folder,
                 "Write a Python package, whose C is compiled when it is installed, in place of -o")
      ->type_name("DIR");
}

void PackageOption::require_sense(CLI::App &command) const {
  if (is_given()) require_no_source_options(command, "--package");
}

OutputFolder PackageOption::package(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                                    bool several) const {
  std::string const path =
      folder_path(several ? (std::filesystem::path(folder) / plan.graph->kernel).string() : folder);
  return {path, package_files(plan, options, mode, path)};
}

} // namespace symreal::tool
