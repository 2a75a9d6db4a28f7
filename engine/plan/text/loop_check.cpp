#include "engine/plan/text/loop_check.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

using reroll::Leaf, reroll::LoopFunction, reroll::LoopStep;

// Operations of all iterations that are examined: more are refused, as examining them would take minutes.
constexpr std::uint64_t most_examined = 100'000'000;

// Follows which elements of memory and which results the steps have stored.
class StepCheck {
public:
  StepCheck(Plan const &plan, PlanFunction const &function)
      : plan_(plan),
        function_(function),
        memory_(function.loops->memory),
        results_(function.results.size()) {}

  // The first thing that is wrong with a step; empty if it is sound.
  std::string find_fault(LoopStep const &step) {
    std::size_t const carried = static_cast<std::size_t>(std::ranges::count(step.leaves, true, &Leaf::is_carried));
    Graph const &body = step.body;
    if (body.input_count() != step.leaves.size()) return "the body has as many inputs as the step has leaves";
    if (body.output_count() != step.stores.size() + carried)
      return "the results of the body are what the step stores, and then what its leaves carry";
    if (!body.guards.empty() || body.last_effect != no_node || body.parameter_count() != 0)
      return "a body has neither guards nor effects nor parameters";
    for (Node const &node : body.nodes)
      if (is_call(node.op) || is_wide(node.op)) return "loops have neither calls nor integers of 64 bits";
    examined_ += std::uint64_t{step.count} * (body.nodes.size() + step.stores.size() + 1);
    if (step.count == 0 || examined_ > most_examined) return "the steps have no iterations, or too many";
    if (step.nest && !is_nest_of(*step.nest, step.count)) return "the nest has another number of iterations";
    std::size_t result = step.stores.size();
    for (Leaf const &leaf : step.leaves)
      if (leaf.is_carried && body.results[result++] != leaf.next)
        return "the last results of the body are what its leaves carry";
    for (Leaf const &leaf : step.leaves)
      if (leaf.access.is_listed() && leaf.access.elements.size() != step.count)
        return "an access has an element per iteration";
    for (reroll::Store const &store : step.stores)
      if (store.access.is_listed() && store.access.elements.size() != step.count)
        return "an access has an element per iteration";
    for (std::uint32_t k = 0; k < step.count; ++k)
      if (std::string fault = iteration(step, k); !fault.empty()) return fault;
    return {};
  }

  std::string find_fault_at_end() {
    LoopFunction const &loops = *function_.loops;
    for (reroll::Mirror const &mirror : loops.mirrors) {
      if (mirror.first + std::uint64_t{mirror.rows} * mirror.rows > results_.size())
        return "the matrix is beyond the results";
      reroll::for_each_copy(mirror, [&](std::uint32_t to, std::uint32_t from) { results_[to] = results_[from]; });
    }
    std::size_t const guards = info(function_.kind).guards == GuardExit::none ? 0 : plan_.graph->guards.size();
    if (loops.checks.size() != guards) return "each guard has one 'check'";
    for (std::uint32_t const element : loops.checks)
      if (element >= memory_.size() || !memory_[element]) return "a guard is checked that no step has computed";
    return std::ranges::count(results_, 0) == 0 ? "" : "a result is not stored";
  }

private:
  // Turns are not empty, so that products of the numbers stay small.
  static bool is_nest_of(reroll::Nest const &nest, std::uint32_t count) {
    if (nest.turns == 0 || nest.turns > count || nest.inner == 0 || nest.inner > count) return false;
    std::int64_t const last = nest.inner + std::int64_t{nest.growth} * (nest.turns - 1);
    return last > 0 && last <= count && reroll::begin_of(nest, nest.turns) == count;
  }

  std::string iteration(LoopStep const &step, std::uint32_t k) {
    for (Leaf const &leaf : step.leaves) {
      if (leaf.array == Array::values || (leaf.is_carried && k != 0)) continue;
      std::size_t const element = leaf.access.at(k);
      if (element >= size_of(leaf.array)) return fmt::format("iteration {} reads an element beyond its array", k);
      if (leaf.array == Array::memory && !memory_[element])
        return fmt::format("iteration {} reads memory that no step has stored", k);
    }
    for (reroll::Store const &store : step.stores) {
      std::vector<char> &array = store.is_result ? results_ : memory_;
      std::size_t const element = store.access.at(k);
      if (element >= array.size()) return fmt::format("iteration {} stores an element beyond its array", k);
      array[element] = 1;
    }
    return {};
  }

  std::size_t size_of(Array array) const {
    return array == Array::memory ? memory_.size() : reads(function_.kind, array) ? plan_.extent(array) : 0;
  }

  Plan const &plan_;
  PlanFunction const &function_;
  std::vector<char> memory_, results_; // whether the element is stored
  std::uint64_t examined_ = 0;
};

} // namespace

std::string find_fault(Plan const &plan, PlanFunction const &function) {
  StepCheck check(plan, function);
  for (std::size_t k = 0; k < function.loops->steps.size(); ++k)
    if (std::string const fault = check.find_fault(function.loops->steps[k]); !fault.empty())
      return fmt::format("step {}: {}", k, fault);
  return check.find_fault_at_end();
}

} // namespace symreal
