#include "trace/pool.h"

#include "trace/events.h"

#include <atomic>
#include <bit>
#include <cmath>

namespace symreal {

__thread std::uint64_t detail::executed[static_cast<unsigned>(Op::count)] = {};

static constexpr std::uint64_t missing_bits = 0x7FF8'0000'4D15'5145u;

double missing_value() noexcept { return std::bit_cast<double>(missing_bits); }

namespace trace {

bool is_missing(double value) { return std::bit_cast<std::uint64_t>(value) == missing_bits; }

Pool &Pool::current() {
  static constinit thread_local Pool *pool = nullptr;
  if (!pool) pool = new Pool;
  return *pool;
}

void Pool::begin() {
  static std::atomic<std::uint8_t> last_generation = 0;
  generation_ = ++last_generation;
  recording_ = true;
  table_.clear();
  values_.clear();
}

std::vector<Node> Pool::end() {
  recording_ = false;
  generation_ = 0;
  return table_.release();
}

RealNumber Pool::number(NodeId id) const {
  return RealNumber::from_bits(detail::node_tag << 40 | std::uint64_t{generation_} << 32 | id);
}

RealNumber Pool::leaf(Node const &node, double value) {
  NodeId id = table_.intern(node);
  if (id == values_.size()) values_.push_back(value);
  return number(id);
}

NodeId Pool::checked(RealNumber number) const {
  if (generation_of(number) != generation_ || !recording_) {
    report_here(DiagnosticId::stale_value, recording_ ? "a value of another kernel or thread is used in this kernel"
                                                      : "a value of a kernel is used outside of it");
    give_up();
  }
  return static_cast<NodeId>(number.to_bits());
}

NodeId Pool::node(RealNumber number) {
  if (number.is_node()) return checked(number);
  // A node that went through uninstrumented arithmetic is quiet, through fabs or negation without its sign.
  constexpr std::uint64_t left_alone = ~(std::uint64_t{1} << 63 | std::uint64_t{1} << 51);
  if (std::isnan(number.plain()) && (number.to_bits() & left_alone) >> 40 == (detail::node_tag & left_alone >> 40)) {
    report_here(DiagnosticId::leak, "a symbolic value came back from code that was not rewritten");
    give_up();
  }
  NodeId id = table_.constant(number.plain());
  if (id == values_.size()) values_.push_back(number.plain());
  return id;
}

double Pool::value_of(Node const &node) const {
  double operand[3] = {0, 0, 0};
  for (unsigned i = 0; i < arity(node.op); ++i) {
    operand[i] = values_[node.operand[i]];
    if (is_missing(operand[i])) return missing_value();
  }
  return evaluate(node.op, operand[0], operand[1], operand[2]);
}

RealNumber Pool::record(Op op, RealNumber x, RealNumber y, RealNumber z) {
  unsigned operands = arity(op);
  NodeId a = node(x), b = operands > 1 ? node(y) : no_node, c = operands > 2 ? node(z) : no_node;
  NodeId id = table_.intern(table_.operation(op, a, b, c));
  if (id == values_.size()) values_.push_back(value_of(table_[id]));
  return number(id);
}

double Pool::carried_value(RealNumber number) {
  if (!number.is_node()) return number.plain();
  return values_[checked(number)];
}

} // namespace trace

namespace detail {

using trace::Pool;

RealNumber record(Op op, RealNumber x, RealNumber y, RealNumber z) noexcept {
  return Pool::current().record(op, x, y, z);
}

double carried_value(RealNumber x) noexcept { return Pool::current().carried_value(x); }

} // namespace detail
} // namespace symreal
