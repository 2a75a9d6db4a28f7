#include "tool/analysis/parallel_option.h"

#include "engine/analysis/sharing/sharing.h"
#include "tool/analysis/figures_report.h"
#include "tool/options/pass_options.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::tool {

namespace {

// Thread costs of a cost file that has them.
ThreadCosts const &thread_costs_of(Costs const &costs) {
  if (costs.scale == 1)
    fail(DiagnosticId::bad_option, {},
         fmt::format("--parallel asks what threads cost, which --cost={} does not say: symreal measure-costs writes a "
                     "file that does",
                     costs.name));
  bool const is_one = costs.threads && !costs.threads->is_measured();
  if (!costs.threads || (!is_one && costs.threads->sections.empty()))
    fail(DiagnosticId::cost_file, {costs.name},
         "this file does not say what sections of OpenMP cost; symreal measure-costs measures it where the compiler "
         "has OpenMP");
  return *costs.threads;
}

// Refuses guards combined with effects: threads can neither skip nor repeat a call that has effects.
void require_shareable(Graph const &graph) {
  if (!graph.guards.empty() && graph.last_effect != no_node)
    fail(DiagnosticId::bad_option, {},
         fmt::format("kernel '{}' has guards, and calls functions with effects: threads would call them before it is "
                     "known that the guards hold; leave --parallel out",
                     graph.kernel));
}

[[noreturn]] void refuse(Graph const &graph, std::string const &why, std::string const &way_out) {
  fail(DiagnosticId::parallel_does_not_pay, {}, fmt::format("kernel '{}': {}", graph.kernel, why), {{{}, way_out}});
}

std::string batch_of(Sharing const &sharing) {
  double const rate = 1e9 / sharing.one_thread;
  return fmt::format("a batch gives more: {} samples at once are up to {:.3g} per second in place of {:.3g}",
                     sharing.threads, sharing.threads * rate, rate);
}

std::string parts_of(Sharing const &sharing) {
  return fmt::format("{} to compute, {} to begin and to end {} stage{}, {} to move {} values",
                     time_text(sharing.computing), time_text(sharing.meeting), sharing.stages,
                     sharing.stages == 1 ? "" : "s", time_text(sharing.moving), sharing.crossing);
}

} // namespace

void ParallelOption::add_to(CLI::App &app) {
  app.add_option("--parallel", threads,
                 "Emit C with OpenMP in which P threads share an evaluation if --cost shows that it pays")
      ->check(CLI::Range(2U, most_threads))
      ->type_name("P");
  app.add_option("--cost", cost, "Costs for --parallel, from symreal measure-costs")->type_name("FILE");
}

Plan ParallelOption::shared(Plan plan, std::string &remark) const {
  if (!is_given()) return plan;
  Graph const &graph = *plan.graph;
  Costs const costs = costs_named(cost);
  ThreadCosts const &machine = thread_costs_of(costs);
  require_costs(costs, graph);
  require_shareable(graph);
  StatementTasks const statements = statement_tasks(plan, costs);
  auto const count = static_cast<std::size_t>(
      std::ranges::count_if(statements.tasks.duration, [](Time duration) { return duration != 0; }));
  std::string const batch = "a batch gives more: each thread evaluates samples of its own";
  if (machine.cores < threads)
    refuse(graph,
           fmt::format("{} threads would take turns: the machine has {} core{}", threads, machine.cores,
                       machine.cores == 1 ? "" : "s"),
           batch);
  if (count < threads)
    refuse(graph, fmt::format("{} threads have {} statement{} to share", threads, count, count == 1 ? "" : "s"), batch);
  Sharing const sharing = share_out(plan, statements, costs, threads);
  std::string const one = time_text(sharing.one_thread);
  if (sharing.stages == 0)
    refuse(graph,
           fmt::format("one thread takes {}, and no stage is worth {} threads: to begin and to end one takes {}", one,
                       threads, time_text(machine.sections_for(threads))),
           batch_of(sharing));
  if (!sharing.pays())
    refuse(graph,
           fmt::format("{} threads take {} where one takes {}: {}", threads, time_text(sharing.together()), one,
                       parts_of(sharing)),
           batch_of(sharing));
  remark = fmt::format("{} threads take {} by these costs where one takes {}, {:.2f} times as fast: {}", threads,
                       time_text(sharing.together()), one, sharing.one_thread / sharing.together(), parts_of(sharing));
  return shared_out(plan, sharing.shares, threads);
}

} // namespace symreal::tool
