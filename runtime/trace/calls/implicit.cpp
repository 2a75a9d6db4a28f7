#include "runtime/trace/calls/implicit.h"

#include "engine/graph/implicit.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

namespace symreal::trace {

void Implicit::begin(std::string const &label, Place const &place) {
  parts_.push_back({label, place, {}, {}});
  is_open_ = true;
}

void Implicit::element(RealNumber *number) {
  parts_.back().places.push_back(number);
  parts_.back().numbers.push_back(*number);
}

void Implicit::end() {
  is_open_ = false;
  if (parts_.size() == 2) {
    relate(parts_[0], parts_[1]);
    parts_.clear();
  }
}

void Implicit::relate(Part const &unknown, Part const &residual) const {
  auto const refuse = [](Part const &part, std::string const &why) {
    report({DiagnosticId::pragma_item, part.place, "implicit(x, r): '" + part.label + "' " + why});
    give_up();
  };
  std::size_t const count = unknown.numbers.size();
  if (residual.numbers.size() != count)
    refuse(residual, "has " + std::to_string(residual.numbers.size()) + " numbers, and '" + unknown.label + "' has " +
                         std::to_string(count));
  Pool &pool = Pool::current();
  for (RealNumber const number : unknown.numbers) {
    if (!number.is_node()) refuse(unknown, "depends on no input: nothing was solved");
    if (is_leaf(pool.nodes()[pool.node(number)].op)) refuse(unknown, "is an input or a parameter: nothing was solved");
  }
  for (RealNumber const number : residual.numbers)
    if (!number.is_node()) refuse(residual, "does not depend on '" + unknown.label + "'");
  NodeTable const &nodes = pool.nodes();
  void const *const caller = __builtin_return_address(0);
  NodeId list = pool.node(0.0);
  for (std::vector<RealNumber> const *numbers : {&unknown.numbers, &residual.numbers})
    for (RealNumber const number : *numbers)
      list = pool.node(pool.leaf(nodes.operation(Op::argument, list, pool.node(number)), 0, caller));
  auto const function = Externals::current().number(implicit_function(static_cast<std::uint32_t>(count)));
  NodeId const called = pool.node(static_cast<double>(function));
  NodeId const call = pool.node(pool.leaf(nodes.operation(Op::call, list, called), 0, caller));
  for (std::size_t k = 0; k < count; ++k) {
    NodeId const which = pool.node(static_cast<double>(k));
    *unknown.places[k] =
        pool.leaf(nodes.operation(Op::returned, call, which), pool.carried_value(unknown.numbers[k]), caller);
  }
}

} // namespace symreal::trace
