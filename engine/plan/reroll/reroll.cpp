#include "engine/plan/reroll/reroll.h"

#include "engine/graph/statistics.h"
#include "engine/plan/reroll/check.h"
#include "engine/plan/reroll/interchange.h"
#include "engine/plan/reroll/plan.h"
#include "engine/plan/reroll/signs.h"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace symreal {

namespace {

// Reason why the graph cannot have loops; empty if it can.
std::string obstacle(Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!live[id] || is_leaf(graph.nodes[id].op)) continue;
    if (is_call(graph.nodes[id].op)) return "it calls external functions";
    if (is_wide(graph.nodes[id].op)) return "it computes with integers of 64 bits";
  }
  return {};
}

// Whether rows of chains need no index table with an entry per iteration.
bool is_short(reroll::LoopStep const &step) {
  using reroll::Access, reroll::Leaf, reroll::Store;
  auto const fits = [&](Access const &access) { return !access.is_listed() || nested(access, *step.nest); };
  auto const is_short_leaf = [&](Leaf const &leaf) {
    return leaf.array == Array::values ? leaf.by_turn : fits(leaf.access);
  };
  return !step.nest ||
         (std::ranges::all_of(step.leaves, is_short_leaf) && std::ranges::all_of(step.stores, fits, &Store::access));
}

// Whether the stage is still a whole loop.
bool is_whole(reroll::Repeat const &stage, std::vector<reroll::Repeat> const &loops) {
  return std::ranges::any_of(loops, [&](reroll::Repeat const &loop) {
    return loop.begin == stage.begin && loop.period == stage.period && loop.count == stage.count;
  });
}

// Outputs and guards of a function, and its floating-point mode.
struct Wanted {
  std::vector<NodeId> const &stored, &checked;
  std::vector<Object> const &objects;
  FloatingPoint mode;
};

// `original`: an equivalent sequence to prove the loops against; null for this one.
std::optional<reroll::LoopFunction> loops_of(std::function<reroll::Sequence()> const &make_sequence,
                                             reroll::Sequence const *original, Wanted const &wanted) {
  using namespace reroll;
  // Rows of chains may prove unusable: if another step needs a value that they overwrite, or signs differ from chain to
  // chain. Then each stage becomes a loop.
  for (bool const in_rows : {true, false}) {
    auto [all, stages] = interchanged(make_sequence(), in_rows);
    std::vector<Repeat> repeats = find_repeats(all, stages);
    align(all, repeats);
    repeats = trimmed(all, repeats);
    if (repeats.empty()) return {};
    if (!std::ranges::all_of(stages, [&](Repeat const &stage) { return !stage.rows || is_whole(stage, repeats); }))
      continue;
    std::optional<LoopFunction> function = reroll::plan(all, repeats, wanted.stored, wanted.checked, wanted.objects);
    if (!function) continue;
    bool const zeros_have_signs = wanted.mode == FloatingPoint::strict;
    if (!zeros_have_signs) function = with_few_signs(std::move(*function));
    if (!std::ranges::all_of(function->steps, is_short)) continue;
    Sequence const &proved = original ? *original : all;
    internal_check(find_difference(proved, *function, wanted.stored, wanted.checked, zeros_have_signs).empty());
    return function;
  }
  internal_check(false);
}

// Operation count of the generated code.
std::size_t text_of(reroll::LoopFunction const &function) {
  std::size_t size = 0;
  for (reroll::LoopStep const &step : function.steps) {
    OperationCounts const counts = live_operations(step.body);
    size += counts.arithmetic() + counts.calls();
  }
  return size;
}

std::optional<reroll::LoopFunction> loops_of(Plan const &plan, FunctionKind kind, Wanted const &wanted) {
  using namespace reroll;
  std::vector<NodeId> roots = wanted.stored;
  roots.insert(roots.end(), wanted.checked.begin(), wanted.checked.end());
  auto const make = [&] { return sequence(plan, kind, roots); };
  std::optional<OwnProducts> const own = with_own_products(make());
  std::optional<LoopFunction> loops = loops_of(make, nullptr, wanted);
  if (!own) return loops;
  Sequence const original = make();
  std::optional<LoopFunction> other = loops_of([&] { return own->sequence; }, &original, wanted);
  // Duplicated products execute more operations, so the code must become much shorter.
  bool const is_better = other && text_of(*other) * 4 < (loops ? text_of(*loops) : original.size()) * 3;
  return is_better ? std::move(other) : std::move(loops);
}

} // namespace

Rerolled rerolled(Plan const &plan, FloatingPoint mode) {
  if (std::string why = obstacle(*plan.graph); !why.empty()) return {{}, std::move(why)};
  std::vector<NodeId> conditions;
  for (Guard const &guard : plan.graph->guards) conditions.push_back(guard.condition);
  std::vector<NodeId> const unchecked;
  std::vector<Object> const unnamed;
  Rerolled loops;
  for (PlanFunction const &function : plan.functions) {
    Wanted const wanted{function.results, info(function.kind).guards == GuardExit::none ? unchecked : conditions,
                        info(function.kind).fills == Array::output ? plan.graph->outputs : unnamed, mode};
    if (std::optional<reroll::LoopFunction> found = loops_of(plan, function.kind, wanted))
      loops.functions.emplace(function.kind, std::move(*found));
  }
  if (!loops.has_loops()) loops.why_not = "no operations repeat often enough";
  return loops;
}

Rerolled improved(Rerolled loops, Angles const &angles, reroll::Improve const &improve) {
  for (auto &[kind, function] : loops.functions) reroll::improve_bodies(function, angles, improve);
  return loops;
}

OperationCounts executed_operations(Plan const &plan, Rerolled const &loops) {
  OperationCounts counts;
  for (Op const op : {Op::sin, Op::cos}) counts[op] += plan.angles.size();
  for (auto const &[kind, function] : loops.functions)
    for (reroll::LoopStep const &step : function.steps) {
      if (kind == FunctionKind::preprocess) break;
      OperationCounts const body = live_operations(step.body);
      for (OperationInfo const &operation : operations()) counts[operation.op] += step.count * body[operation.op];
    }
  PlanFunction const *const angles = plan.find(FunctionKind::angles);
  if (!angles || loops.functions.contains(FunctionKind::angles)) return counts;
  for (reroll::Operation const &operation : reroll::sequence(plan, angles->kind, angles->results).operations)
    ++counts[plan.graph->nodes[operation.node].op];
  return counts;
}

Plan with_loops(Plan plan, Rerolled loops) {
  for (auto &[kind, function] : loops.functions) plan.make(kind).loops = std::move(function);
  return plan;
}

std::string describe(Rerolled const &loops) {
  std::string text;
  for (auto const &[kind, function] : loops.functions)
    text += fmt::format("{}{}: {} loop{} hold{} {} of {} operations", text.empty() ? "" : "; ", info(kind).name,
                        function.loops, function.loops == 1 ? "" : "s", function.loops == 1 ? "s" : "",
                        function.in_loops, function.operations);
  return text;
}

} // namespace symreal
