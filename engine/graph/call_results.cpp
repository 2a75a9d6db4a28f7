#include "engine/graph/call_results.h"

#include "engine/graph/complex_function.h"
#include "engine/graph/implicit.h"

namespace symreal {

std::vector<double> CallResults::called(std::size_t function, std::vector<double> const &arguments) const {
  External const &external = graph_.externals[function];
  if (is_implicit(external)) return {arguments.begin(), arguments.begin() + external.parameters[2].count};
  std::vector<double> results(external.result_count());
  if (std::optional<ComplexFunction> const known = find_complex_function(external)) {
    evaluate(*known, arguments, results);
    return results;
  }
  internal_check(static_cast<bool>(call_));
  call_(function, arguments, results);
  return results;
}

} // namespace symreal
