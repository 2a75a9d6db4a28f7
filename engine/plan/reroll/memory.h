// Memory layout of a function: elements of its own array for values that cross steps.
//
// A loop has one record per iteration, with the values that it stores. Extra records surround them: where a later loop
// reads beyond the first or the last record, they hold copies of values from elsewhere. If iterations are independent,
// records are spread (a structure of arrays): each field is contiguous over the records, as vectorisation requires.
// Rows of chains (interchange.h) have one record per chain, which the next row overwrites. A field of which only the
// last iteration is read, such as a sum, has one element. Elements whose value is dead are reused.
#pragma once

#include "engine/plan/loop_function.h"
#include "engine/plan/reroll/columns.h"

#include <map>
#include <optional>

namespace symreal::reroll {

// Storage allocation: offsets of blocks in an array, where blocks with disjoint live ranges share elements.

// Live range of a value in memory: the steps of its first write and its last read.
struct Life {
  std::uint32_t first, last;

  void reach(std::uint32_t step) { last = step > last ? step : last; }
};

struct Block {
  std::size_t size;
  Life life;
};

struct Storage {
  std::vector<std::size_t> begins; // per block
  std::size_t size = 0;            // of the array
};

// First-fit allocation of the blocks, in order of the begin of their live ranges.
Storage stored(std::vector<Block> const &blocks);

// An operation of a loop body in one iteration; iterations before the first are negative.
struct Cell {
  std::uint32_t loop, position;
  std::int64_t iteration;
  auto operator<=>(Cell const &) const = default;
};

class Memory {
public:
  // `step_of`: per operation the step of the function that computes it.
  Memory(Sequence const &sequence, std::vector<LoopBody> const &loops, std::vector<std::uint32_t> step_of);

  std::uint32_t step_of_loop(std::uint32_t loop) const { return step_of_[loops_[loop].repeat.begin]; }

  // Loop and iteration that compute the node; nullopt if no loop does.
  std::optional<Cell> cell(NodeId node) const;
  bool is_real(Cell const &cell) const {
    return cell.iteration >= 0 && cell.iteration < static_cast<std::int64_t>(loops_[cell.loop].repeat.count);
  }
  // Whether a later row of its chain overwrites the value of the node.
  bool is_overwritten(NodeId node) const;

  // Phase 1: declares the values that a step reads.
  void need(NodeId node, std::uint32_t step);
  void need(Cell const &cell, std::uint32_t step);
  // Likewise; a value that would be overwritten gets a copy that is kept.
  void need_kept(NodeId node, std::uint32_t step);
  // Whether a step reads a value after it is overwritten; then the steps must be planned anew.
  bool is_overwritten_early() const { return is_overwritten_early_; }
  // Whether a record outside the loop may hold a copy of the node.
  bool may_hold_copy(Cell const &cell, NodeId node) const;
  // Reserves the copy; the preceding step writes it. Returns whether it is new.
  bool hold_copy(Cell const &cell, NodeId node, std::uint32_t step);

  // Phase 2: assigns elements; `spread`: per loop whether its records are spread.
  void lay_out(std::vector<char> const &spread);
  std::uint32_t home(NodeId node) const;
  bool has_home(NodeId node) const;
  std::uint32_t element(Cell const &cell) const;
  std::int64_t stride(std::uint32_t loop) const { return regions_[loop].stride; }
  // Positions in rows of chains whose values are kept, with the element of the copy in each iteration.
  std::vector<std::pair<std::uint32_t, Access>> kept_positions(std::uint32_t loop) const;
  // Element that each iteration stores to; in rows of chains also the element that it reads from the row before.
  Access in_iterations(std::uint32_t loop, std::uint32_t position) const;
  // Positions of the body's operations that the loop stores.
  std::vector<std::uint32_t> stored_positions(std::uint32_t loop) const;
  std::size_t size() const { return size_; }

private:
  struct Place {
    Life life;
    std::uint32_t element = 0; // of a field, in the first record
    bool of_last = true;       // of a field: only the record of the last iteration is read
  };
  struct Region {
    std::map<std::uint32_t, Place> fields; // by position
    std::map<std::uint32_t, Place> kept;   // of rows of chains: one element per iteration
    std::int64_t first = 0, last = 0;      // range of the records: iterations, or chains of rows of chains
    std::int64_t stride = 0;               // distance between records
  };

  Place &field(std::uint32_t loop, std::uint32_t position, std::uint32_t step);
  bool is_last(Cell const &cell) const;
  std::int64_t record(Cell const &cell) const;

  Sequence const &sequence_;
  std::vector<LoopBody> const &loops_;
  std::vector<std::uint32_t> step_of_, loop_of_; // per operation; no_position if it is outside loops
  std::vector<Region> regions_;
  std::map<Cell, NodeId> copies_;
  std::map<NodeId, Place> singles_;
  std::size_t size_ = 0;
  bool is_overwritten_early_ = false;
};

} // namespace symreal::reroll
