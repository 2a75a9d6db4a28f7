#include "tool/options/differentiate_option.h"

#include "engine/optimise/differentiate/differentiate.h"

namespace symreal::tool {

void DifferentiateOption::add_to(CLI::App &app) {
  app.add_option("--differentiate", requests,
                 "Add derivatives as outputs: jacobian(y, x), gradient(y), hessian(y, x), jvp(y, x) or vjp(y, x) of "
                 "outputs y by inputs x; lists in brackets: jacobian(tau, [q, qd]); a matrix may be sparse, a Hessian "
                 "also symmetric and weighted: hessian([cost, g], x, weighted, sparse); repeatable")
      ->type_name("DERIVATIVE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void DifferentiateOption::add_separate_to(CLI::App &app) {
  app.add_flag("--separate", separate,
               "Emit derivatives as a separate function, in a separate file beside the kernel's");
}

Graph DifferentiateOption::applied(Graph graph, Report const &report) const {
  std::vector<DerivativeWish> wishes = std::move(graph.wishes);
  graph.wishes.clear();
  for (std::string const &request : requests) wishes.push_back({request, {}});
  return wishes.empty() ? std::move(graph) : differentiate(std::move(graph), wishes, report);
}

} // namespace symreal::tool
