#include "tool/package/externals.h"

#include "engine/graph/complex_function.h"

namespace symreal::tool {

void require_no_externals(Graph const &graph) {
  for (External const &external : graph.externals)
    if (!find_complex_function(external))
      fail(DiagnosticId::bad_option, {},
           "kernel '" + graph.kernel + "' calls '" + external.name +
               "', whose library would not be brought along: generate C with --lang=c, and link it yourself");
}

} // namespace symreal::tool
