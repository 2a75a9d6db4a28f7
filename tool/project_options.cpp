#include "tool/project_options.h"

#include "diagnostics/diagnostic.h"
#include "tool/recovery.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

namespace symreal::tool {

// Of the sources, and of where the user is.
static void recover_trees(std::vector<std::string> const &sources) {
  std::set<std::string> directories = {"."};
  for (std::string const &source : sources) {
    std::string const directory = std::filesystem::path(source).parent_path().string();
    if (!directory.empty()) directories.insert(directory);
  }
  for (std::string const &directory : directories) recover(directory);
}

void ProjectOptions::add_to(CLI::App &app) {
  app.add_option("sources", request.sources, "C and C++ sources; with -p by default all of them");
  app.add_option("--root", request.roots,
                 "A further directory whose files may be rewritten, besides the sources' own (repeatable)")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
  add_build_to(app);
}

void ProjectOptions::add_build_to(CLI::App &app) {
  app.add_option("-p", build, "Directory of the compile_commands.json that says how the sources are compiled")
      ->type_name("DIR");
  app.add_option("-j", request.jobs, "How many sources are read at once; by default as many as there are processors")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
}

rewrite::Request ProjectOptions::complete(CompilerFlags const &flags) const {
  rewrite::Request complete = request;
  if (complete.jobs == 0) complete.jobs = std::max(1U, std::thread::hardware_concurrency());
  if (build.empty() && complete.sources.empty())
    fail(DiagnosticId::bad_option, {}, "sources, or a directory with -p, say what is read");
  complete.flags = flags;
  if (build.empty()) {
    recover_trees(complete.sources);
    return complete;
  }
  complete.compilations = rewrite::read_compile_commands(build, request.sources);
  complete.sources.clear();
  for (rewrite::Compilation &one : complete.compilations) {
    one.flags.insert(one.flags.end(), flags.begin(), flags.end());
    complete.sources.push_back(one.source);
  }
  std::vector<std::string> paths;
  for (rewrite::Compilation const &one : complete.compilations)
    paths.push_back((std::filesystem::path(one.directory) / one.source).string());
  recover_trees(paths);
  return complete;
}

} // namespace symreal::tool
