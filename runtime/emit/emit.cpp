#include "emit/emit.h"

#include "emit/c_parts.h"
#include "emit/trace.h"

namespace symreal {

std::string prefixed(EmitOptions const &options, std::string const &name) {
  return options.prefix.empty() ? name : options.prefix + "_" + name;
}

std::vector<EmittedFile> emit_c(Graph const &graph, EmitOptions const &options) {
  Program const program = schedule(graph, options.check_values ? Nesting::none : Nesting::bounded);
  std::vector<EmittedFile> files = {{options.base_name + ".c", c_source(program, options)},
                                    {options.base_name + ".h", c_header(program, options)}};
  files[0].origins = resolve_markers(files[0].text, graph, options.trace_comments);
  if (options.mainline) files.push_back({options.base_name + "_main.c", c_mainline(program, options)});
  return files;
}

} // namespace symreal
