#include "schedule/chunks.h"

#include <algorithm>

namespace symreal {

static constexpr std::size_t most_statements = 500;

namespace {

class Cutter {
public:
  Cutter(Program const &program, FunctionBody const &body, bool in_compute)
      : program_(program),
        body_(body),
        in_compute_(in_compute),
        chunk_(program.graph->nodes.size(), no_slot),
        last_reader_(program.graph->nodes.size(), 0) {}

  Chunks cut() {
    Chunks chunks{{}, std::vector<std::uint32_t>(chunk_.size(), no_slot), 0};
    std::size_t const count = body_.variables.size();
    for (std::size_t statement = 0; statement < count; statement += most_statements) chunks.begin.push_back(statement);
    if (chunks.begin.empty()) chunks.begin.push_back(0);
    chunks.begin.push_back(count);
    if (chunks.size() == 1) return chunks;

    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        NodeId id = body_.variables[statement];
        chunk_[id] = static_cast<std::uint32_t>(chunk);
        note_reads(id, chunk);
      }
    for (Check const &check : body_.checks) note_use(check.condition, chunks.of_check(check));
    for (NodeId result : body_.results)
      if (chunk_[result] != no_slot) last_reader_[result] = static_cast<std::uint32_t>(chunks.size());
    assign_slots(chunks);
    return chunks;
  }

private:
  // The variables that a statement reads, through the expressions nested in it.
  void note_reads(NodeId statement, std::size_t chunk) {
    stack_.assign(1, statement);
    while (!stack_.empty()) {
      Node const &node = program_.graph->nodes[stack_.back()];
      stack_.pop_back();
      if (is_leaf(node.op)) continue;
      for (NodeId operand : node.operand)
        if (operand != no_node) note_read(operand, chunk);
    }
  }

  void note_use(NodeId id, std::size_t chunk) {
    stack_.clear();
    note_read(id, chunk);
    if (!stack_.empty()) note_reads(id, chunk);
  }

  void note_read(NodeId id, std::size_t chunk) {
    if (in_compute_ && program_.constant_slot[id] != no_slot) return;
    if (chunk_[id] != no_slot)
      last_reader_[id] = std::max(last_reader_[id], static_cast<std::uint32_t>(chunk));
    else
      stack_.push_back(id);
  }

  void assign_slots(Chunks &chunks) {
    std::vector<std::uint32_t> free;
    std::vector<std::vector<std::uint32_t>> dies_after(chunks.size() + 1);
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        NodeId id = body_.variables[statement];
        if (last_reader_[id] <= chunk) continue;
        if (free.empty()) free.push_back(static_cast<std::uint32_t>(chunks.spill_count++));
        chunks.spill_slot[id] = free.back();
        free.pop_back();
        dies_after[last_reader_[id]].push_back(chunks.spill_slot[id]);
      }
      free.insert(free.end(), dies_after[chunk].begin(), dies_after[chunk].end());
    }
  }

  Program const &program_;
  FunctionBody const &body_;
  bool in_compute_;
  std::vector<std::uint32_t> chunk_;       // per node that is a variable: where it is set
  std::vector<std::uint32_t> last_reader_; // and the last chunk that reads it
  std::vector<NodeId> stack_;
};

} // namespace

std::size_t Chunks::of_check(Check const &check) const {
  auto after = std::lower_bound(begin.begin() + 1, begin.end(), check.before);
  return static_cast<std::size_t>(after - begin.begin()) - 1;
}

Chunks cut(Program const &program, FunctionBody const &body, bool in_compute) {
  return Cutter(program, body, in_compute).cut();
}

} // namespace symreal
