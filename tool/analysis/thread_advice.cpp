#include "tool/analysis/blocks_report.h"
#include "tool/analysis/times.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace symreal::tool {

namespace {

void print_times(std::ostream &out, Advice const &advice) {
  auto const row = [&](std::string const &name, double nanoseconds, std::string const &why) {
    fmt::print(out, "  {:<18}{:>14}   {}\n", name, time_text(nanoseconds), why);
  };
  fmt::print(out, "by these costs one evaluation takes at least\n");
  row("on one core", advice.one_core, "the larger of work and longest path");
  row("by levels", advice.by_levels,
      fmt::format("{} levels, a barrier of {} each", advice.levels, time_text(advice.barrier)));
  row("by blocks", advice.by_blocks,
      fmt::format("up to {} hand-overs of {} in a row, with one to begin and one to end", advice.hand_overs,
                  time_text(advice.hand_over)));
  row("in graph order", advice.in_order, "no bound, but an estimate: by blocks, each in the order of the graph");
}

void print_verdict(std::ostream &out, Advice const &advice) {
  if (advice.pays() && !advice.pays_in_order())
    fmt::print(
        out,
        "Threads do not pay for one evaluation in the order of the graph; in the best of orders {} may be {:.2f} "
        "times as fast as one.\n",
        advice.threads, advice.one_core / advice.best());
  else if (advice.pays())
    fmt::print(out,
               "Threads may pay for one evaluation: at best {} are {:.2f} times as fast as one, in the order of the "
               "graph {:.2f} times. A program must show it.\n",
               advice.threads, advice.one_core / advice.best(), advice.one_core / advice.in_order);
  else
    fmt::print(out, "Threads do not pay for one evaluation: at best {} take {:.3g} times as long as one.\n",
               advice.threads, advice.best() / advice.one_core);
  fmt::print(out, "A level is worth its barrier from {:.0f} of these operations on; it has {:.1f} on average.\n",
             advice.width_to_pay, advice.level_width);
  fmt::print(out, "So many hand-overs are at best worth it from {} on one core on; these operations take {}.\n",
             time_text(advice.time_to_pay), time_text(advice.one_core));
  fmt::print(out,
             "A batch gives more: {} samples at once are up to {:.3g} per second in place of {:.3g}, from {} samples a "
             "call on.\n",
             advice.threads, advice.batch_rate, advice.batch_rate / advice.threads, advice.batch_to_pay);
}

} // namespace

void print_advice(std::ostream &out, BlocksReport const &report) {
  Costs const &costs = *report.costs;
  std::uint32_t const count = report.kernel->blocks.count;
  if (costs.scale == 1 || count < 2) return; // not measured on a machine, or only one block
  if (!costs.threads) {
    fmt::print(out, "Whether threads pay '{}' does not say; symreal measure-costs measures it.\n", costs.name);
    return;
  }
  ThreadCosts const &threads = *costs.threads;
  if (!threads.is_measured()) {
    fmt::print(out, "Threads do not pay: the machine has one processor, on which they take turns.\n");
    return;
  }
  internal_check(report.advice.has_value()); // measured threads imply advice
  print_times(out, *report.advice);
  if (count > threads.processors)
    fmt::print(out, "The machine has {} processors: {} threads take turns on it. This is of one that has enough.\n",
               threads.processors, count);
  else if (count > threads.cores)
    fmt::print(out, "The machine has {} cores: some of {} threads share one, and are slower than is said here.\n",
               threads.cores, count);
  print_verdict(out, *report.advice);
}

} // namespace symreal::tool
