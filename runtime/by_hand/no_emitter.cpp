#include "runtime/trace/report/events.h"
#include "runtime/trace/sinks.h"

namespace symreal::trace {

void generate_here(Graph const &graph, std::string const &) {
  report({DiagnosticId::no_emitter,
          {},
          "kernel '" + graph.kernel + "' is recorded, and this program is linked without an emitter"});
  give_up();
}

} // namespace symreal::trace
