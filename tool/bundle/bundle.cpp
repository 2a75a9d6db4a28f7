#include "tool/bundle/bundle.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/graph/external.h"
#include "tool/bundle/fmu.h"
#include "tool/bundle/package.h"

#include <filesystem>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

void require_no_externals(Graph const &graph) {
  for (External const &external : graph.externals)
    if (!find_complex_function(external))
      fail(DiagnosticId::bad_option, {},
           "kernel '" + graph.kernel + "' calls '" + external.name +
               "', whose library would not be brought along: generate C with --lang=c, and link it yourself");
}

} // namespace

void Bundle::add_to(Outputs &outputs) const {
  outputs.files.insert(outputs.files.end(), units.begin(), units.end());
  if (!package.path.empty()) outputs.folders.push_back(package);
}

void BundleOption::add_to(CLI::App &app) {
  app.add_option("--package", package,
                 "Write a Python package, whose C is compiled when it is installed, in place of -o")
      ->type_name("DIR");
  app.add_option("--fmu", unit, "Write a functional mock-up unit (FMI 3.0) of a kernel with states, in place of -o")
      ->type_name("FILE");
}

void BundleOption::require_sense() const {
  if (!names_directory(unit) && fs::path(unit).has_extension() && fs::path(unit).extension() != ".fmu")
    fail(DiagnosticId::bad_option, {}, "the result is a file whose name ends in .fmu, not '" + unit + "'");
}

Bundle BundleOption::bundle(Plan const &plan, EmitterOptions const &options, FloatingPoint mode, bool several) const {
  Graph const &graph = *plan.graph;
  require_no_externals(graph);
  Bundle bundle;
  if (!package.empty()) {
    std::string const path = folder_path(several ? (fs::path(package) / graph.kernel).string() : package);
    bundle.package = {path, package_files(plan, options, mode, path)};
  }
  if (!unit.empty()) {
    bool const is_directory = several || names_directory(unit);
    bundle.units.push_back(
        {is_directory ? (fs::path(unit) / (graph.kernel + ".fmu")).string() : unit, unit_bytes(plan, options, mode)});
  }
  return bundle;
}

} // namespace symreal::tool
