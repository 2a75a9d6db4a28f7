#include "tool/commands/bundle.h"

namespace symreal::tool {

std::vector<OutputFile> Bundle::files() const {
  std::vector<OutputFile> all = package.files;
  all.insert(all.end(), units.begin(), units.end());
  return all;
}

void Bundle::add_to(Outputs &outputs) const {
  outputs.files.insert(outputs.files.end(), units.begin(), units.end());
  if (!package.path.empty()) outputs.folders.push_back(package);
}

void BundleOption::add_to(CLI::App &app) {
  package.add_to(app);
  unit.add_to(app);
}

void BundleOption::require_sense(CLI::App &command) const {
  package.require_sense(command);
  unit.require_sense(command);
}

Bundle BundleOption::bundle(Schedule const &plan, EmitterOptions const &options, FloatingPoint mode,
                            bool several) const {
  Bundle bundle;
  if (package.is_given()) bundle.package = package.package(plan, options, mode, several);
  if (unit.is_given()) bundle.units.push_back(unit.unit(plan, options, mode, several));
  return bundle;
}

} // namespace symreal::tool
