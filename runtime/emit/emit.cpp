#include "emit/emit.h"

#include "emit/c/parts.h"
#include "emit/origins/origins.h"

namespace symreal {

std::vector<EmittedFile> emit_c(Graph const &graph, EmitOptions const &options) {
  Schedule const plan = schedule(graph, options.check_values ? Nesting::none : Nesting::bounded);
  std::vector<EmittedFile> files = {{options.base_name + ".c", c_source(plan, options)},
                                    {options.base_name + ".h", c_header(plan, options)}};
  files[0].origins = resolve_markers(files[0].text, graph, options.trace_comments);
  if (options.mainline) files.push_back({options.base_name + "_main.c", c_mainline(plan, options)});
  return files;
}

} // namespace symreal
