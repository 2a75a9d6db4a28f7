// The array of a function: where values stand that other steps read.
//
// A loop has a record for each iteration with what it stores. Some records more lie around them: where a later loop
// reads beyond the first or the last, copies of the values stand that it would have found elsewhere.
#pragma once

#include "reroll/columns.h"

#include <map>
#include <optional>

namespace symreal::reroll {

// An operation of the body of a loop, in an iteration; those before the first are negative.
struct Cell {
  std::uint32_t loop, position;
  std::int64_t iteration;
  auto operator<=>(Cell const &) const = default;
};

class Memory {
public:
  Memory(Sequence const &sequence, std::vector<LoopBody> const &loops);

  // Which iteration of which loop computes the node.
  std::optional<Cell> cell(NodeId node) const;
  bool is_real(Cell const &cell) const {
    return cell.iteration >= 0 && cell.iteration < static_cast<std::int64_t>(loops_[cell.loop].repeat.count);
  }

  // First what is needed is said:
  void need(NodeId node);
  void need(Cell const &cell) { regions_[cell.loop].fields.try_emplace(cell.position, 0); }
  // Whether a copy of the node may stand at a cell that is not real. It does from then on.
  bool may_hold_copy(Cell const &cell, NodeId node) const;
  // Whether this is the first time.
  bool hold_copy(Cell const &cell, NodeId node);

  // Then where it stands:
  void lay_out();
  std::uint32_t home(NodeId node) const;
  bool has_home(NodeId node) const;
  std::uint32_t element(Cell const &cell) const;
  std::int64_t stride(std::uint32_t loop) const { return static_cast<std::int64_t>(regions_[loop].fields.size()); }
  // By position: what the loop stores.
  std::map<std::uint32_t, std::uint32_t> const &fields(std::uint32_t loop) const { return regions_[loop].fields; }
  std::size_t size() const { return size_; }

private:
  struct Region {
    std::map<std::uint32_t, std::uint32_t> fields; // by position: the element of a record
    std::int64_t first = 0, last = 0;              // iterations with records
    std::size_t begin = 0;                         // element of the first record
  };

  Sequence const &sequence_;
  std::vector<LoopBody> const &loops_;
  std::vector<std::uint32_t> loop_of_; // per operation, or no_position
  std::vector<Region> regions_;
  std::map<Cell, NodeId> copies_;
  std::map<NodeId, std::uint32_t> singles_;
  std::size_t size_ = 0;
};

} // namespace symreal::reroll
