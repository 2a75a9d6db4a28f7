#include "tool/project_options.h"

#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <thread>

namespace symreal::tool {

void ProjectOptions::add_to(CLI::App &app) {
  app.add_option("sources", request.sources, "C and C++ sources; with -p by default all of them");
  app.add_option("-p", build, "Directory of the compile_commands.json that says how the sources are compiled")
      ->type_name("DIR");
  app.add_option("-j", request.jobs, "How many sources are read at once; by default as many as there are processors")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  app.add_option("--root", request.roots,
                 "A further directory whose files may be rewritten, besides the sources' own (repeatable)")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
}

rewrite::Request ProjectOptions::complete(CompilerFlags const &flags) const {
  rewrite::Request complete = request;
  if (complete.jobs == 0) complete.jobs = std::max(1U, std::thread::hardware_concurrency());
  if (build.empty() && complete.sources.empty())
    fail(DiagnosticId::bad_option, {}, "sources, or a directory with -p, say what is read");
  complete.flags = flags;
  if (build.empty()) return complete;
  complete.compilations = rewrite::read_compile_commands(build, request.sources);
  complete.sources.clear();
  for (rewrite::Compilation &one : complete.compilations) {
    one.flags.insert(one.flags.end(), flags.begin(), flags.end());
    complete.sources.push_back(one.source);
  }
  return complete;
}

} // namespace symreal::tool
