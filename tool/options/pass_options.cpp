#include "tool/options/pass_options.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/optimise/passes/snap.h"
#include "engine/support/files.h"
#include "engine/support/number.h"

namespace symreal::tool {

void PassOptions::add_to(CLI::App &app) {
  app.add_option("--fp", mode, "Floating-point mode: finite, strict or fast")->capture_default_str();
  std::string names;
  for (PassInfo const &pass : pass_table()) names += std::string(names.empty() ? "" : ", ") + std::string(pass.name);
  passes_option =
      app.add_option("--passes", passes, "Passes, separated by commas, or default or none; available: " + names)
          ->capture_default_str();
  effort_option =
      app.add_option("--effort", effort, "Effort of structure recovery, 0 (none) to 3 (minutes); mode fast only")
          ->capture_default_str();
  app.add_option("--target-cost", target_cost,
                 "Operation costs on the target, which guide the passes: unit (1 each), table (the table of "
                 "operations), or a file written by symreal measure-costs")
      ->type_name("unit|table|FILE")
      ->capture_default_str();
  app.add_flag("--snap{" + shortest(usual_snap) + "}", snap,
               "Round computed constants within this distance of 0, 1, -1, 1/2 or -1/2 to these numbers (mode fast)");
  tolerance_option =
      app.add_option("--tol", tolerance, "Largest relative change of an output due to --snap")->capture_default_str();
}

std::optional<double> PassOptions::snap_distance() const {
  if (tolerance_option && tolerance_option->count() != 0 && snap.empty())
    fail(DiagnosticId::option_without_effect, {}, "--tol has no effect without --snap");
  if (snap.empty()) return std::nullopt;
  if (floating_point() != FloatingPoint::fast)
    fail(DiagnosticId::option_without_effect, {}, "--snap has no effect without --fp=fast");
  std::optional<double> const distance = parse_number(snap);
  if (!distance || !(*distance > 0 && *distance <= largest_snap))
    fail(DiagnosticId::bad_option, {},
         "--snap takes a distance above 0 and up to " + shortest(largest_snap) + ", not '" + snap + "'");
  return distance;
}

PassSettings PassOptions::settings() const {
  if (effort < algebra::least_effort || effort > algebra::most_effort)
    fail(DiagnosticId::bad_option, {}, "--effort takes 0, 1, 2 or 3, not " + std::to_string(effort));
  if (effort_option && effort_option->count() != 0 && floating_point() != FloatingPoint::fast)
    fail(DiagnosticId::option_without_effect, {}, "--effort has no effect without --fp=fast");
  (void)snap_distance();
  return {floating_point(), effort, cost_model(costs_named(target_cost))};
}

FloatingPoint PassOptions::floating_point() const {
  auto parsed = parse_floating_point(mode);
  if (!parsed) fail(DiagnosticId::bad_option, {}, "--fp takes finite, strict or fast, not '" + mode + "'");
  return *parsed;
}

std::vector<std::string> PassOptions::names() const { return parse_passes(passes); }

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

Costs costs_named(std::string const &cost) {
  if (cost == "unit") return unit_cost_model();
  if (cost == "table") return table_cost_model();
  return read_costs(read_file(cost), cost);
}

void add_cost_option(CLI::App &app, std::string &cost) {
  app.add_option("--cost", cost,
                 "Cost of an operation: unit (1), table (the table of operations), or a file of symreal measure-costs")
      ->type_name("unit|table|FILE")
      ->capture_default_str();
}

} // namespace symreal::tool
