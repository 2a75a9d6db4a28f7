#include "engine/analysis/sharing/statements.h"

#include "engine/plan/schedule/order.h"
#include "engine/plan/schedule/parts.h"

#include <algorithm>
#include <cmath>

namespace symreal {

namespace {

class Reader {
public:
  Reader(Schedule const &plan, Costs const &costs)
      : plan_(plan),
        body_(plan.compute),
        costs_(costs),
        task_(body_.regions.value_count(), no_node),
        path_(body_.regions.value_count(), 0) {}

  StatementTasks run() {
    StatementTasks result;
    for (std::size_t k = 0; k < body_.variables.size(); ++k) {
      add_costs(body_.variables[k]);
      std::vector<TaskId> before;
      for_each_before(
          plan_, body_, k, [&](NodeId id) { return is_task(id); }, [&](NodeId id) { before.push_back(task_[id]); });
      task_[body_.variables[k]] = static_cast<TaskId>(k);
      result.tasks.add(std::llround(throughput_ * StatementTasks::scale), before);
      result.latency.push_back(latency_ * StatementTasks::scale / costs_.scale);
    }
    result.is_result.assign(body_.variables.size(), 0);
    auto const mark = [&](NodeId use) {
      for_each_read(
          *plan_.graph, use, [&](NodeId id) { return is_task(id); },
          [&](NodeId id) { return is_read(plan_, true, id); }, [&](NodeId id) { result.is_result[task_[id]] = 1; });
    };
    std::ranges::for_each(body_.results, mark);
    for (Check const &check : body_.checks) mark(check.condition);
    return result;
  }

private:
  bool is_task(NodeId id) const { return task_[id] != no_node; }
  bool is_nested(NodeId id) const { return id != no_node && !is_task(id) && !is_read(plan_, true, id); }

  // Sums the costs of the operations in the expression, innermost first, since operands have smaller ids.
  void add_costs(NodeId variable) {
    throughput_ = 0;
    latency_ = 0;
    if (body_.regions.is_gate(variable) || is_read(plan_, true, variable)) return;
    std::vector<NodeId> nested = {variable};
    for (std::size_t k = 0; k < nested.size(); ++k)
      for (NodeId operand : operands(nested[k]))
        if (is_nested(operand)) nested.push_back(operand);
    std::ranges::sort(nested);
    for (NodeId id : nested) {
      auto const op = static_cast<std::size_t>(plan_.graph->nodes[id].op);
      Time longest = 0;
      for (NodeId operand : operands(id))
        if (is_nested(operand)) longest = std::max(longest, path_[operand]);
      path_[id] = longest + costs_.latency[op];
      throughput_ += costs_.throughput[op];
    }
    latency_ = path_[variable];
  }

  // Operands without the preceding call, which only orders calls.
  std::span<NodeId const> operands(NodeId id) const {
    Node const &node = plan_.graph->nodes[id];
    return {node.operand.data(), node.op == Op::call_in_order ? 2 : node.operand.size()};
  }

  Schedule const &plan_;
  FunctionBody const &body_;
  Costs const &costs_;
  std::vector<TaskId> task_; // statement that defines the value
  std::vector<Time> path_;   // per nested operation, in parts of the costs' unit
  double throughput_ = 0;
  Time latency_ = 0;
};

} // namespace

StatementTasks statement_tasks(Schedule const &plan, Costs const &costs) { return Reader(plan, costs).run(); }

} // namespace symreal
