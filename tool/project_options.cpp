#include "tool/project_options.h"

namespace symreal::tool {

void ProjectOptions::add_to(CLI::App &app) {
  app.add_option("sources", request.sources, "C and C++ sources")->required();
  app.add_option("--root", request.roots,
                 "A further directory whose files may be rewritten, besides the sources' own (repeatable)")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("DIR");
}

rewrite::Request ProjectOptions::complete(CompilerFlags const &flags) const {
  rewrite::Request complete = request;
  complete.flags = flags;
  return complete;
}

} // namespace symreal::tool
