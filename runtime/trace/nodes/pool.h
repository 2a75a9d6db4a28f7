// The pool of one thread: the graph that is being recorded, and what its nodes carry: their values, and on request the
// return addresses of the code that recorded them.
//
// One pool per thread rather than one behind a mutex: kernels recorded by several threads do not meet, and the
// generation in each node tells one pool's nodes from another's.
#pragma once

#include "engine/graph/node_table.h"
#include "runtime/trace/nodes/payload.h"

#include <symreal/annotate.h>
#include <symreal/symbolic.h>

#include <utility>
#include <vector>

namespace symreal::trace {

// Whatever is computed from a missing value is missing, too.
bool is_missing(double value);

class Pool {
public:
  // Constant-initialised, made on first use, never destroyed: numbers with static storage outlive it otherwise.
  static Pool &current();

  struct Columns {
    bool values = true;  // without: whatever decides, prints or converts is an error
    bool places = false; // 4 bytes a node
  };
  // As $SYMREAL_VALUES and $SYMREAL_PLACES ask for.
  static Columns wanted_columns();

  // Begins a recording with a generation of its own.
  void begin(Columns columns = wanted_columns());
  // Ends it: what is left are the nodes, handed over. Numbers that still hold one are stale from now on.
  Nodes end();
  bool is_recording() const { return recording_; }

  // An input, a parameter, or the node of an opaque operation, whose value is not computed from its operands.
  RealNumber leaf(Node const &node, double value, void const *caller = nullptr);
  // `caller`: the return address of the code that asks.
  RealNumber record(Op op, RealNumber x, RealNumber y, RealNumber z, void const *caller = nullptr);

  // The node behind a number; a constant is interned. Leaks and stale nodes end the program with a diagnostic.
  NodeId node(RealNumber number) {
    if (is_own(number.to_bits())) return payload::id_of(number.to_bits());
    if (number.is_node() && number.to_bits() != payload::signaling) return refuse(number);
    return node_of_constant(number);
  }
  double carried_value(RealNumber number);
  // Bits of a node of any recording, also where code that was not rewritten made it quiet or changed its sign.
  static bool is_tagged(std::uint64_t bits) {
    RealNumber const number = underlying(bits);
    return number.is_node() && is_known(payload::generation_of(number.to_bits()));
  }
  // The node behind tagged bits.
  static RealNumber underlying(std::uint64_t bits) {
    return RealNumber::from_bits((bits & ~marks) | std::uint64_t{1} << 63);
  }
  // What is left of a node where some of its bytes were overwritten.
  static bool is_torn(RealNumber number) {
    return number.is_node() && number.to_bits() != payload::signaling && !is_tagged(number.to_bits());
  }
  // The recording has outgrown the memory: gives its memory back, so that this can be told, and ends the program.
  [[noreturn]] void run_out();
  bool owns(RealNumber number) const { return is_own(number.to_bits()); }
  // The last operation that may have set errno, if that was not written since.
  RealNumber last_to_set_error() const { return error_setter_ == no_node ? RealNumber(0.0) : number(error_setter_); }
  void may_set_error(RealNumber x) { error_setter_ = owns(x) ? payload::id_of(x.to_bits()) : error_setter_; }
  void forget_error() { error_setter_ = no_node; }

  // What a number becomes when its kernel ends.
  double final_value(RealNumber number) const { return value(payload::id_of(number.to_bits())); }
  void make_plain(RealNumber &number) const {
    if (owns(number)) number = final_value(number); // what is no node may lie in constant memory
  }
  // All numbers that lie in these bytes, from the first on.
  void make_plain(void *begin, std::size_t size) const {
    auto *numbers = static_cast<RealNumber *>(begin);
    for (std::size_t k = 0; k < size / sizeof *numbers; ++k) make_plain(numbers[k]);
  }

  NodeTable const &nodes() const { return table_; }
  RealNumber number(NodeId id) const;

  // A node with what it carries.
  struct Row {
    Node node;
    double value;
    std::uint32_t place;
    bool is_exact;
  };
  std::vector<Row> rows_from(NodeId first) const;
  // Of another process that has recorded the same as this one up to node `first`. Returns what each node is here.
  std::vector<NodeId> adopt(NodeId first, std::vector<Row> const &rows);
  // From now on what is recorded is exact, or no longer; returns what held before.
  bool set_exact(bool exact) { return std::exchange(exact_, exact); }
  // Per node; empty where none is.
  std::vector<char> exact() const;
  // Per node, relative to the load base; 0 where unknown; empty where places are not kept.
  LongArray<std::uint32_t> take_places() { return std::exchange(places_, {}); }

private:
  static constexpr std::uint64_t marks = std::uint64_t{1} << 63 | std::uint64_t{1} << 51;
  // Was there a recording of this generation?
  static bool is_known(std::uint32_t generation);
  // A node of this recording; another process that records the same may have more of them.
  bool is_own(std::uint64_t bits) const { return bits >> 32 == payload::upper_half(payload::id_of(bits), offset_); }
  NodeId node_of_constant(RealNumber number);
  void make_room();
  double value(NodeId id) const;
  double value_of(Node const &node) const;
  NodeId record_arithmetic(Op op, RealNumber x, RealNumber y, void const *caller);
  // Says what is wrong with the number, and ends the program: it has no node.
  NodeId refuse(RealNumber number) const;
  // An operand, which this process has.
  NodeId operand(RealNumber number) {
    NodeId const id = node(number);
    return id < table_.size() ? id : refuse(number);
  }
  void mark_exact(NodeId id);
  // Fills the columns for a node if it is new.
  void fill(NodeId id, double value, void const *caller);

  NodeTable table_;
  Columns columns_;
  LongArray<double> values_; // the carried value of each node
  LongArray<std::uint32_t> places_;
  std::uint8_t generation_ = 0;
  std::uint32_t offset_ = 0; // of the generation, in the payload
  bool recording_ = false;
  LongArray<char> exact_nodes_; // up to the last that is
  bool exact_ = false;          // a statement or function says so, which may stand around a whole recording
  NodeId error_setter_ = no_node;
};

// In the pool of this thread. `caller`: where in the program this is asked for.
RealNumber record_call(Op op, RealNumber x, RealNumber y, RealNumber z, void const *caller) noexcept;

} // namespace symreal::trace
