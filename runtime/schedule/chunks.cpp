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
    begin_chunks(chunks, most_statements);
    if (chunks.size() == 1 && !chunks.has_parts()) return chunks;

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
  void begin_chunks(Chunks &chunks, std::size_t most_statements) const {
    std::size_t begin = 0;
    auto const cut_up_to = [&](std::size_t end) {
      for (; begin < end; begin = std::min(begin + most_statements, end)) chunks.begin.push_back(begin);
    };
    for (std::size_t part = 0; part < body_.parts.size(); ++part) {
      cut_up_to(body_.parts[part].end);
      chunks.part.resize(chunks.begin.size(), part);
    }
    cut_up_to(body_.variables.size());
    if (chunks.begin.empty()) chunks.begin.push_back(0);
    chunks.begin.push_back(body_.variables.size());
  }

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

  // A slot is used again behind the chunk that reads it last. Between threads that is only known where a stage ends;
  // but what no other part reads is the part's own.
  void assign_slots(Chunks &chunks) {
    std::vector<std::uint32_t> free, own, of_stage; // for this part: left by earlier stages, and by itself
    std::vector<std::vector<std::uint32_t>> dies_after(chunks.size() + 1), dies_in_part(chunks.size() + 1);
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
        std::vector<std::uint32_t> &from = own.empty() ? free : own;
        if (from.empty()) from.push_back(static_cast<std::uint32_t>(chunks.spill_count++));
        chunks.spill_slot[id] = from.back();
        from.pop_back();
        bool const stays =
            last_reader_[id] < chunks.size() && part_of(chunks, last_reader_[id]) == part_of(chunks, chunk);
        (stays ? dies_in_part : dies_after)[last_reader_[id]].push_back(chunks.spill_slot[id]);
      }
      own.insert(own.end(), dies_in_part[chunk].begin(), dies_in_part[chunk].end());
      of_stage.insert(of_stage.end(), dies_after[chunk].begin(), dies_after[chunk].end());
      bool const ends = chunk + 1 == chunks.size();
      if (ends || part_of(chunks, chunk) != part_of(chunks, chunk + 1)) move_all(own, of_stage);
      if (ends || stage_of(chunks, chunk) != stage_of(chunks, chunk + 1)) move_all(of_stage, free);
    }
  }

  static void move_all(std::vector<std::uint32_t> &from, std::vector<std::uint32_t> &to) {
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
  }
  static std::size_t part_of(Chunks const &chunks, std::size_t chunk) {
    return chunks.has_parts() ? chunks.part[chunk] : 0;
  }
  std::size_t stage_of(Chunks const &chunks, std::size_t chunk) const {
    return chunks.has_parts() ? body_.parts[chunks.part[chunk]].stage : 0;
  }

  Schedule const &plan_;
  FunctionBody const &body_;
  bool in_compute_;
  std::vector<std::uint32_t> chunk_;       // per node that is a variable, and gate: where it is set
  std::vector<std::uint32_t> last_reader_; // and the last chunk that reads it
};

} // namespace

std::size_t Chunks::of_check(Check const &check) const {
  if (has_parts()) return size();
  auto after = std::lower_bound(begin.begin() + 1, begin.end(), check.before);
  return static_cast<std::size_t>(after - begin.begin()) - 1;
}

Chunks cut(Schedule const &plan, FunctionBody const &body, bool in_compute, std::size_t most_statements) {
  return Cutter(plan, body, in_compute).cut(most_statements);
}

} // namespace symreal
