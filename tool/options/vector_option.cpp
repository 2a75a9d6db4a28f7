#include "tool/options/vector_option.h"

#include "engine/diagnostics/diagnostic.h"

namespace symreal::tool {

void VectorOption::add_to(CLI::App &app) {
  app.add_option("--vector", width, "Emit C or C++ with vector operations of 2, 4 or 8 lanes")
      ->type_name("N")
      ->check(CLI::IsMember({2U, 4U, 8U}));
}

void VectorOption::require_sense(EmitterOptions const &emitter, bool is_parallel, bool is_rerolled) const {
  if (!is_given()) return;
  if (is_parallel)
    fail(DiagnosticId::bad_option, {}, "--parallel shares out statements, of which --vector makes one of several");
  if (is_rerolled) fail(DiagnosticId::bad_option, {}, "--reroll makes loops of statements, and --vector vectors");
  if (emitter.check_values)
    fail(DiagnosticId::bad_option, {},
         "--check-values makes a statement of each operation, and --vector one of several");
}

std::optional<Laned> VectorOption::lanes(Schedule const &plan, std::vector<Diagnostic> &remarks,
                                         std::string &text) const {
  if (!is_given()) return {};
  Laned lanes = laned(plan, width);
  if (!lanes.compute) {
    remarks.push_back(
        {DiagnosticId::no_vectors, {}, "kernel '" + plan.graph->kernel + "' has no vectors: " + lanes.why_not});
    return {};
  }
  text = describe(*lanes.compute);
  return lanes;
}

} // namespace symreal::tool
