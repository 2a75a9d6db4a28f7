// The array of a function: where values stand that other steps read.
//
// A loop has a record for each iteration with what it stores. Some records more lie around them: where a later loop
// reads beyond the first or the last, copies of the values stand that it would have found elsewhere. Where iterations
// do not wait for each other, a record is spread: its fields each stand beside those of the next record, as compilers
// need it to carry out iterations at the same time. Rows of chains (interchange.h) have a record for each chain, which
// the next row overwrites. Where only the last iteration's value is read, as of a sum, each overwrites that of the one
// before. What nobody reads any more leaves its place to others.
#pragma once

#include "engine/plan/reroll/columns.h"
#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/storage.h"

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
  // `step_of`: per operation the step of the function that computes it.
  Memory(Sequence const &sequence, std::vector<LoopBody> const &loops, std::vector<std::uint32_t> step_of);

  std::uint32_t step_of_loop(std::uint32_t loop) const { return step_of_[loops_[loop].repeat.begin]; }

  // Which iteration of which loop computes the node.
  std::optional<Cell> cell(NodeId node) const;
  bool is_real(Cell const &cell) const {
    return cell.iteration >= 0 && cell.iteration < static_cast<std::int64_t>(loops_[cell.loop].repeat.count);
  }
  // Whether it is of rows of chains and not of the last row, whose values stay.
  bool is_overwritten(NodeId node) const;

  // First what a step reads is said:
  void need(NodeId node, std::uint32_t step);
  void need(Cell const &cell, std::uint32_t step);
  // Likewise; what is overwritten has a copy that is kept.
  void need_kept(NodeId node, std::uint32_t step);
  // By the next row of the same chains, which begins with what they have before the loop.
  void need_in_chain(std::uint32_t loop, std::uint32_t position);
  // Whether somebody needs what is overwritten: then the steps must be others.
  bool is_overwritten_early() const { return is_overwritten_early_; }
  // Whether a copy of the node may stand at a cell that is not real. It does from then on.
  bool may_hold_copy(Cell const &cell, NodeId node) const;
  // The step before writes it. Whether this is the first time.
  bool hold_copy(Cell const &cell, NodeId node, std::uint32_t step);

  // Then where it stands; per loop whether its records are spread.
  void lay_out(std::vector<char> const &spread);
  std::uint32_t home(NodeId node) const;
  bool has_home(NodeId node) const;
  std::uint32_t element(Cell const &cell) const;
  std::int64_t stride(std::uint32_t loop) const { return regions_[loop].stride; }
  // Of the operations of rows of chains whose values are kept, where each iteration stores the copy.
  std::vector<std::pair<std::uint32_t, Access>> kept_positions(std::uint32_t loop) const;
  // Where each iteration stores the value; of rows of chains also where it finds that of the row before.
  Access in_iterations(std::uint32_t loop, std::uint32_t position) const;
  // Of the operations of a body that the loop stores.
  std::vector<std::uint32_t> stored_positions(std::uint32_t loop) const;
  std::size_t size() const { return size_; }

private:
  struct Place {
    Life life;
    std::uint32_t element = 0; // of a field, in the first record
    bool of_last = true;       // of a field: nobody reads another record than that of the last iteration
  };
  struct Region {
    std::map<std::uint32_t, Place> fields; // by position
    std::map<std::uint32_t, Place> kept;   // of rows of chains: with an element for each iteration
    std::int64_t first = 0, last = 0;      // iterations with records; of rows of chains, chains
    std::int64_t stride = 0;               // from a record to the next
  };

  Place &field(std::uint32_t loop, std::uint32_t position, std::uint32_t step);
  bool is_last(Cell const &cell) const;
  std::int64_t record(Cell const &cell) const;

  Sequence const &sequence_;
  std::vector<LoopBody> const &loops_;
  std::vector<std::uint32_t> step_of_, loop_of_; // per operation; no loop: no_position
  std::vector<Region> regions_;
  std::map<Cell, NodeId> copies_;
  std::map<NodeId, Place> singles_;
  std::size_t size_ = 0;
  bool is_overwritten_early_ = false;
};

} // namespace symreal::reroll
