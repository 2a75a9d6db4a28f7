// The pool of one thread: the graph being recorded with its node attributes: the carried values, and on request the
// return addresses of the code that recorded them.
//
// Each thread has its own (trace/session.h): the generation in a node tells one pool's nodes from another's.
#pragma once

#include "engine/graph/node_table.h"
#include "runtime/trace/nodes/payload.h"
#include "runtime/trace/parts/parts.h"

#include <symreal/annotate.h>
#include <symreal/symbolic.h>

#include <utility>
#include <vector>

namespace symreal::trace {

// Missing values propagate through operations.
bool is_missing(double value);

class Pool {
public:
  explicit Pool(TornNumbers &torn_numbers) : torn_numbers_(torn_numbers) {}

  struct Columns {
    bool values = true;  // false: a decision, print or conversion is an error
    bool places = false; // 4 bytes a node
  };
  // Columns that the entries `values` and `places` of the request ask for.
  static Columns wanted_columns();

  // Begins a recording with a generation of its own.
  void begin(Columns columns = wanted_columns());
  // Ends the recording and hands its nodes over. Numbers that still hold one are stale from now on.
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
  // Whether the number is a node of which some bytes were overwritten.
  static bool is_torn(RealNumber number) {
    return number.is_node() && number.to_bits() != payload::signaling && !is_tagged(number.to_bits());
  }
  // Ends the program with a diagnostic when the recording has outgrown memory; frees the recording first.
  [[noreturn]] void run_out();
  bool owns(RealNumber number) const { return is_own(number.to_bits()); }
  // The last operation that may have set errno, if that was not written since.
  RealNumber last_to_set_error() const { return error_setter_ == no_node ? RealNumber(0.0) : number(error_setter_); }
  void may_set_error(RealNumber x) { error_setter_ = owns(x) ? payload::id_of(x.to_bits()) : error_setter_; }
  void forget_error() { error_setter_ = no_node; }

  // Plain value that replaces a node when its kernel ends.
  double final_value(RealNumber number) const { return value(payload::id_of(number.to_bits())); }
  void make_plain(RealNumber &number) const {
    if (owns(number)) number = final_value(number); // a plain number may lie in read-only memory
  }
  // Makes all numbers in these bytes plain.
  void make_plain(void *begin, std::size_t size) const {
    auto *numbers = static_cast<RealNumber *>(begin);
    for (std::size_t k = 0; k < size / sizeof *numbers; ++k) make_plain(numbers[k]);
  }

  NodeTable const &nodes() const { return table_; }
  RealNumber number(NodeId id) const;

  // A node with its attributes.
  struct Row {
    Node node;
    double value;
    std::uint32_t place;
    bool is_exact;
  };
  std::vector<Row> rows_from(NodeId first) const;
  // Appends the rows of a process that shares this recording up to node `first`. Returns their node ids here.
  std::vector<NodeId> adopt(NodeId first, std::vector<Row> const &rows);
  // Sets whether nodes recorded from now on are exact; returns the previous setting.
  bool set_exact(bool exact) { return std::exchange(exact_, exact); }
  // Exactness per node; empty if no node is exact.
  std::vector<char> exact() const;
  // Return address per node, relative to the load base; 0 if unknown; empty if places are not kept.
  LongArray<std::uint32_t> take_places() { return std::exchange(places_, {}); }

private:
  static constexpr std::uint64_t marks = std::uint64_t{1} << 63 | std::uint64_t{1} << 51;
  // Whether a recording of this generation existed.
  static bool is_known(std::uint32_t generation);
  // A node of this recording; another process that records the same may have more of them.
  bool is_own(std::uint64_t bits) const { return bits >> 32 == payload::upper_half(payload::id_of(bits), offset_); }
  NodeId node_of_constant(RealNumber number);
  void make_room();
  double value(NodeId id) const;
  double value_of(Node const &node) const;
  NodeId record_arithmetic(Op op, RealNumber x, RealNumber y, void const *caller);
  // Reports the number, which has no node, and ends the program.
  NodeId refuse(RealNumber number) const;
  // Operand node, which must exist in this process.
  NodeId operand(RealNumber number) {
    NodeId const id = node(number);
    return id < table_.size() ? id : refuse(number);
  }
  void mark_exact(NodeId id);
  // Fills the columns for a node if it is new.
  void fill(NodeId id, double value, void const *caller);

  TornNumbers &torn_numbers_;
  NodeTable table_;
  Columns columns_;
  LongArray<double> values_; // the carried value of each node
  LongArray<std::uint32_t> places_;
  std::uint8_t generation_ = 0;
  std::uint32_t offset_ = 0; // of the generation, in the payload
  bool recording_ = false;
  LongArray<char> exact_nodes_; // up to the last exact one
  bool exact_ = false;          // set by a statement or function, which may enclose a whole recording
  NodeId error_setter_ = no_node;
};

// Records in the pool of this thread. `caller`: return address in the program.
RealNumber record_call(Op op, RealNumber x, RealNumber y, RealNumber z, void const *caller) noexcept;

} // namespace symreal::trace
