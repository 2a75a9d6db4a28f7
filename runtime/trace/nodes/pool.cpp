#include "runtime/trace/nodes/pool.h"

#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/nodes/torn_numbers.h"
#include "runtime/trace/report/events.h"
#include "runtime/wire/request.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

extern "C" char const __ehdr_start; // the linker's name for where this executable is loaded

namespace symreal {

__thread std::uint64_t detail::executed[static_cast<unsigned>(Op::count)] = {};

static constexpr std::uint64_t missing_bits = 0x7FF8'0000'4D15'5145u;

double missing_value() noexcept { return std::bit_cast<double>(missing_bits); }

namespace trace {

// Code of the executable; anything else is too far away.
static std::uint32_t relative_address(void const *address) {
  auto offset = reinterpret_cast<std::uintptr_t>(address) - reinterpret_cast<std::uintptr_t>(&__ehdr_start);
  return offset <= std::numeric_limits<std::uint32_t>::max() ? static_cast<std::uint32_t>(offset) : 0;
}

bool is_missing(double value) { return std::bit_cast<std::uint64_t>(value) == missing_bits; }

Pool::Columns Pool::wanted_columns() {
  auto has = [](wire::Entry entry, bool otherwise) {
    char const *text = wire::requested(entry);
    return text ? *text != '0' : otherwise;
  };
  return {has(wire::Entry::values, true), has(wire::Entry::places, false)};
}

// Generations that are being recorded now, in any thread.
static std::atomic<std::uint64_t> live[4];

static bool is_live(std::uint32_t generation) { return (live[generation / 64] >> (generation % 64) & 1) != 0; }

// The largest generation so far. Generations restart at 1 when all are used.
static std::atomic<std::uint32_t> last_known = 0;

bool Pool::is_known(std::uint32_t generation) { return generation - 1 < last_known; }

static_assert(payload::generation_of(payload::signaling) > 255); // that of no recording

// The check bits identify each generation, and nodes of all generations differ from bits without check bits.
static_assert([] {
  for (std::uint32_t generation = 1; generation < 256; ++generation) {
    for (NodeId id : {0u, 1u, 0x1234'5678u, 0xFFFF'FFFEu}) {
      std::uint64_t const bits = payload::bits_of(id, payload::offset_of(generation));
      if (payload::generation_of(bits) != generation || payload::id_of(bits) != id) return false;
      if (!RealNumber::from_bits(bits).is_node()) return false;
    }
    std::uint32_t const distance = payload::offset_of(generation) & payload::check_mask;
    if (distance <= 1 || distance == payload::check_mask) return false;
  }
  return true;
}());

void Pool::begin(Columns columns) {
  static std::atomic<std::uint8_t> last_generation = 0;
  do generation_ = ++last_generation;
  while (generation_ == 0); // 0: no recording
  offset_ = payload::offset_of(generation_);
  for (std::uint32_t known = last_known;
       known < generation_ && !last_known.compare_exchange_weak(known, generation_);) {
  }
  live[generation_ / 64] |= std::uint64_t{1} << (generation_ % 64);
  recording_ = true;
  error_setter_ = no_node;
  table_.clear();
  values_.clear();
  places_.clear();
  exact_nodes_.clear();
  columns_ = columns;
  make_room();
}

static bool is_room_for(std::size_t bytes) {
  try {
    unmap_pages(map_pages(bytes), bytes);
    return true;
  } catch (std::bad_alloc const &) {
    return false;
  }
}

// Reserves address space, not memory: under a limit, half of the rest, since the program needs some as well. A
// recording that outgrows it moves.
void Pool::make_room() {
  std::size_t const node_size = sizeof(Node) + 2 * sizeof(NodeId) + sizeof(Attribute) +
                                (columns_.values ? sizeof(double) : 0) + (columns_.places ? sizeof(std::uint32_t) : 0);
  std::size_t count = std::size_t{1} << 28;
  while (count > 1 << 16 && !is_room_for(2 * count * node_size)) count /= 2;
  table_.reserve(count);
  if (columns_.values) values_.reserve(count);
  if (columns_.places) places_.reserve(count);
}

Nodes Pool::end() {
  recording_ = false;
  live[generation_ / 64] &= ~(std::uint64_t{1} << (generation_ % 64));
  generation_ = 0;
  offset_ = 0;
  values_ = {};
  return table_.release();
}

RealNumber Pool::number(NodeId id) const { return RealNumber::from_bits(payload::bits_of(id, offset_)); }

RealNumber Pool::leaf(Node const &node, double value, void const *caller) {
  NodeId id = table_.intern(node);
  fill(id, value, caller);
  return number(id);
}

NodeId Pool::refuse(RealNumber number) const {
  if (is_dropped("check_bits")) return payload::id_of(number.to_bits()) % static_cast<NodeId>(table_.size());
  std::uint32_t const generation = payload::generation_of(number.to_bits());
  if (!is_known(generation) || generation == generation_) {
    std::string const place = torn_numbers_.place_of(number);
    torn_numbers_.end();
    report_here(DiagnosticId::torn_number,
                "a number is used of which a part was overwritten; the rest is that of a symbolic value" +
                    (place.empty() ? "" : ": overwritten at " + place));
  } else {
    report_here(DiagnosticId::stale_value, is_live(generation)
                                               ? "a value of a kernel is used in a thread that does not record it: a "
                                                 "kernel is recorded by the thread that began it"
                                           : recording_ ? "a value of another kernel or thread is used in this kernel"
                                                        : "a value of a kernel is used outside of it");
  }
  give_up();
}

NodeId Pool::node_of_constant(RealNumber number) {
  if (Pool::is_tagged(number.to_bits())) {
    report_here(DiagnosticId::leak, "a symbolic value came back from code that was not rewritten");
    give_up();
  }
  NodeId id = table_.constant(number.plain());
  fill(id, number.plain(), nullptr);
  return id;
}

double Pool::value(NodeId id) const {
  if (columns_.values) return values_[id];
  return table_[id].is_constant() ? table_[id].value() : missing_value();
}

void Pool::fill(NodeId id, double value, void const *caller) {
  if (columns_.values && id == values_.size()) values_.push_back(value);
  if (columns_.places && id == places_.size()) places_.push_back(relative_address(caller));
}

double Pool::value_of(Node const &node) const {
  double operand[3] = {0, 0, 0};
  for (unsigned i = 0; i < arity(node.op); ++i) {
    operand[i] = value(node.operand[i]);
    if (is_missing(operand[i])) return missing_value();
  }
  return evaluate(node.op, operand[0], operand[1], operand[2]);
}

// Fast path for the common operations, without a look-up in the table of operations.
NodeId Pool::record_arithmetic(Op op, RealNumber x, RealNumber y, void const *caller) {
  NodeId const a = operand(x), b = operand(y), id = table_.intern(table_.arithmetic(op, a, b));
  if (id + 1 != table_.size()) return id;
  double value = missing_value();
  if (columns_.values && id == values_.size() && !is_missing(values_[a]) && !is_missing(values_[b]))
    value = evaluate(op, values_[a], values_[b], 0);
  fill(id, value, caller);
  return id;
}

RealNumber Pool::record(Op op, RealNumber x, RealNumber y, RealNumber z, void const *caller) {
  if (op == Op::add || op == Op::sub || op == Op::mul || op == Op::div) {
    NodeId const id = record_arithmetic(op, x, y, caller);
    if (exact_) mark_exact(id);
    return number(id);
  }
  unsigned operands = arity(op);
  NodeId a = operand(x), b = operands > 1 ? operand(y) : no_node, c = operands > 2 ? operand(z) : no_node;
  NodeId id = table_.intern(table_.operation(op, a, b, c));
  if (info(op).has(flag::ERROR)) error_setter_ = id;
  if (id + 1 == table_.size()) // most likely new
    fill(id, columns_.values && id == values_.size() ? value_of(table_[id]) : 0, caller);
  if (exact_) mark_exact(id);
  return number(id);
}

// A computation that also stands elsewhere is one node, and exact.
void Pool::mark_exact(NodeId id) {
  memory::OwnWork const own;
  if (id >= exact_nodes_.size()) exact_nodes_.resize(id + 1, 0);
  exact_nodes_[id] = 1;
}

std::vector<char> Pool::exact() const {
  std::vector<char> result(exact_nodes_.begin(), exact_nodes_.end());
  if (!result.empty()) result.resize(table_.size(), 0);
  return result;
}

std::vector<Pool::Row> Pool::rows_from(NodeId first) const {
  std::vector<Row> rows;
  for (NodeId id = first; id < table_.size(); ++id)
    rows.push_back({table_[id], columns_.values ? values_[id] : missing_value(), columns_.places ? places_[id] : 0,
                    id < exact_nodes_.size() && exact_nodes_[id] != 0});
  return rows;
}

std::vector<NodeId> Pool::adopt(NodeId first, std::vector<Row> const &rows) {
  std::vector<NodeId> now;
  now.reserve(rows.size());
  for (Row const &row : rows) {
    Node node = row.node;
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node && operand >= first) operand = now[operand - first];
    NodeId const id = table_.intern(node);
    if (columns_.values && id == values_.size()) values_.push_back(row.value);
    if (columns_.places && id == places_.size()) places_.push_back(row.place);
    if (row.is_exact) mark_exact(id);
    now.push_back(id);
  }
  return now;
}

void Pool::run_out() {
  std::size_t const count = table_.size();
  table_ = {};
  values_ = {};
  places_ = {};
  recording_ = false;
  report_here(DiagnosticId::out_of_memory, "the recording outgrows the memory: the system gives no more after " +
                                               std::to_string(count) + " operations");
  give_up();
}

double Pool::carried_value(RealNumber number) { return number.is_node() ? value(operand(number)) : number.plain(); }

RealNumber record_call(Op op, RealNumber x, RealNumber y, RealNumber z, void const *caller) noexcept {
  Pool &pool = session().pool;
  try {
    return pool.record(op, x, y, z, caller);
  } catch (std::bad_alloc const &) {
    pool.run_out();
  }
}

} // namespace trace

namespace detail {

using trace::Pool;
using trace::session;

RealNumber record(Op op, RealNumber x, RealNumber y, RealNumber z) noexcept {
  return trace::record_call(op, x, y, z, __builtin_return_address(0));
}

RealNumber operate(Op op, RealNumber x, RealNumber y) noexcept {
  ++executed[static_cast<unsigned>(op)];
  if (x.is_node() || y.is_node()) {
    Pool &pool = session().pool;
    try {
      return pool.record(op, x, y, 0.0, __builtin_return_address(0));
    } catch (std::bad_alloc const &) {
      pool.run_out();
    }
  }
  switch (op) {
  case Op::add: return x.plain() + y.plain();
  case Op::sub: return x.plain() - y.plain();
  case Op::mul: return x.plain() * y.plain();
  default: return x.plain() / y.plain();
  }
}

double carried_value(RealNumber x) noexcept { return session().pool.carried_value(x); }

} // namespace detail
} // namespace symreal
