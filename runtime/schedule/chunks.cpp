#include "schedule/chunks.h"

#include "graph/opaque.h"
#include "schedule/order.h"

#include <algorithm>

namespace symreal {

namespace {

class Cutter {
public:
  Cutter(Schedule const &plan, FunctionBody const &body, bool in_compute)
      : plan_(plan),
        body_(body),
        in_compute_(in_compute),
        chunk_(body.regions.value_count(), no_slot),
        last_reader_(body.regions.value_count(), 0) {}

  Chunks cut(std::size_t most_statements) {
    Chunks chunks{{}, std::vector<std::uint32_t>(chunk_.size(), no_slot), 0};
    std::size_t const count = body_.variables.size();
    for (std::size_t statement = 0; statement < count; statement += most_statements) chunks.begin.push_back(statement);
    if (chunks.begin.empty()) chunks.begin.push_back(0);
    chunks.begin.push_back(count);
    if (chunks.size() == 1) return chunks;

    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        chunk_[body_.variables[statement]] = static_cast<std::uint32_t>(chunk);
        note_reads(statement, chunk);
      }
    for (Check const &check : body_.checks) note_read(check.condition, chunks.of_check(check));
    for (NodeId result : body_.results) note_read(result, chunks.size());
    assign_slots(chunks);
    return chunks;
  }

private:
  // The variables that a statement and the blocks around it read.
  void note_reads(std::size_t statement, std::size_t chunk) {
    for (Literal const &literal : body_.regions.literals(body_.region[statement])) note_read(literal.condition, chunk);
    for_each_operand(plan_, body_, in_compute_, body_.variables[statement],
                     [&](NodeId operand) { note_read(operand, chunk); });
  }

  void note_read(NodeId use, std::size_t chunk) {
    for_each_read(
        *plan_.graph, use, [&](NodeId id) { return chunk_[id] != no_slot; },
        [&](NodeId id) { return is_read(plan_, in_compute_, id); },
        [&](NodeId id) { last_reader_[id] = std::max(last_reader_[id], static_cast<std::uint32_t>(chunk)); });
  }

  void assign_slots(Chunks &chunks) {
    std::vector<std::uint32_t> free;
    std::vector<std::vector<std::uint32_t>> dies_after(chunks.size() + 1);
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        NodeId id = body_.variables[statement];
        if (last_reader_[id] <= chunk) continue;
        if (is_call_node(plan_, body_, id)) { // its results stand side by side
          Graph const &graph = *plan_.graph;
          chunks.spill_slot[id] = static_cast<std::uint32_t>(chunks.spill_count);
          chunks.spill_count += graph.externals[function_of(graph, graph.nodes[id])].result_count();
          continue;
        }
        if (free.empty()) free.push_back(static_cast<std::uint32_t>(chunks.spill_count++));
        chunks.spill_slot[id] = free.back();
        free.pop_back();
        dies_after[last_reader_[id]].push_back(chunks.spill_slot[id]);
      }
      free.insert(free.end(), dies_after[chunk].begin(), dies_after[chunk].end());
    }
  }

  Schedule const &plan_;
  FunctionBody const &body_;
  bool in_compute_;
  std::vector<std::uint32_t> chunk_;       // per node that is a variable, and gate: where it is set
  std::vector<std::uint32_t> last_reader_; // and the last chunk that reads it
};

} // namespace

std::size_t Chunks::of_check(Check const &check) const {
  auto after = std::lower_bound(begin.begin() + 1, begin.end(), check.before);
  return static_cast<std::size_t>(after - begin.begin()) - 1;
}

Chunks cut(Schedule const &plan, FunctionBody const &body, bool in_compute, std::size_t most_statements) {
  return Cutter(plan, body, in_compute).cut(most_statements);
}

} // namespace symreal
