#include "engine/plan/schedule/chunks.h"

#include "engine/graph/opaque.h"
#include "engine/plan/schedule/cuts.h"
#include "engine/plan/schedule/order.h"

#include <algorithm>
#include <numeric>

namespace symreal {

namespace {

class Cutter {
public:
  Cutter(Schedule const &plan, FunctionBody const &body, bool in_compute, ChunkLimits const &limits)
      : plan_(plan),
        body_(body),
        in_compute_(in_compute),
        limits_(limits),
        chunk_(body.regions.value_count(), no_slot),
        last_reader_(body.regions.value_count(), 0),
        last_array_reader_(body.regions.value_count(), no_slot) {}

  Chunks cut() {
    Chunks chunks;
    chunks.statement.assign(chunk_.size(), no_slot);
    for (std::size_t k = 0; k < body_.variables.size(); ++k)
      chunks.statement[body_.variables[k]] = static_cast<std::uint32_t>(k);
    chunks.spill_slot.assign(chunk_.size(), no_slot);
    chunks.copy_slot.assign(chunk_.size(), no_slot);
    begin_chunks(chunks);
    if (chunks.size() == 1 && !chunks.has_parts()) {
      store_behind(chunks);
      return chunks;
    }

    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        chunk_[body_.variables[statement]] = static_cast<std::uint32_t>(chunk);
        note_reads(statement, chunk);
      }
    for (Check const &check : body_.checks) note_read(check.condition, chunks.of_check(check));
    place_stores(chunks);
    assign_slots(chunks);
    return chunks;
  }

private:
  void begin_chunks(Chunks &chunks) const {
    std::size_t const end = body_.variables.size();
    if (body_.parts.empty() && end <= limits_.most_statements) {
      chunks.begin = {0, end};
      return;
    }
    Cuts cuts(plan_, body_, in_compute_);
    std::size_t begin = 0;
    auto const cut_up_to = [&](std::size_t last) {
      std::vector<std::size_t> const begins = cuts.between(begin, last, limits_.most_statements);
      chunks.begin.insert(chunks.begin.end(), begins.begin(), begins.end());
      begin = last;
    };
    for (std::size_t part = 0; part < body_.parts.size(); ++part) {
      cut_up_to(body_.parts[part].end);
      chunks.part.resize(chunks.begin.size(), part);
    }
    cut_up_to(end);
    chunks.begin.push_back(end);
  }

  // Notes the variables and array elements that a statement and the blocks around it read.
  void note_reads(std::size_t statement, std::size_t chunk) {
    NodeId const id = body_.variables[statement];
    for (Literal const &literal : body_.regions.literals(body_.region[statement])) note_read(literal.condition, chunk);
    if (!body_.regions.is_gate(id) && is_read(plan_, in_compute_, id)) note_array_read(id, chunk);
    for_each_operand(plan_, body_, in_compute_, id, [&](NodeId operand) { note_read(operand, chunk); });
  }

  void note_read(NodeId use, std::size_t chunk) {
    auto const is_set = [&](NodeId id) { return chunk_[id] != no_slot; };
    for_each_read(
        *plan_.graph, use, [&](NodeId id) { return is_set(id) || is_read(plan_, in_compute_, id); },
        [](NodeId) { return false; },
        [&](NodeId id) {
          if (is_set(id))
            last_reader_[id] = std::max(last_reader_[id], static_cast<std::uint32_t>(chunk));
          else
            note_array_read(id, chunk);
        });
  }

  void note_array_read(NodeId id, std::size_t chunk) {
    if (!plan_.graph->nodes[id].is_constant()) last_array_reader_[id] = static_cast<std::uint32_t>(chunk);
  }

  void place_stores(Chunks &chunks) {
    if (limits_.may_store && !chunks.has_parts()) {
      std::size_t first_storing = 0;
      for (Check const &check : body_.checks) first_storing = std::max(first_storing, chunks.of_check(check));
      ChunkReads const reads{chunks.size(), first_storing, chunk_, last_reader_, last_array_reader_};
      chunks.stores = distribute(*plan_.graph, body_, reads, limits_.most_statements);
    } else {
      store_behind(chunks);
    }
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (std::size_t const result : chunks.stores.of_chunk[chunk]) note_read(body_.results[result], chunk);
    for (std::size_t const result : chunks.stores.behind) note_read(body_.results[result], chunks.size());
  }

  void store_behind(Chunks &chunks) const {
    chunks.stores.first_chunk = chunks.size();
    chunks.stores.of_chunk.resize(chunks.size());
    chunks.stores.behind.resize(body_.results.size());
    std::iota(chunks.stores.behind.begin(), chunks.stores.behind.end(), std::size_t{0});
  }

  // Reuses a slot behind the chunk that reads it last; across threads, behind the stage of that chunk. A value that
  // only its own part reads has a slot private to the part.
  void assign_slots(Chunks &chunks) {
    std::vector<std::uint32_t> free, own, of_stage; // free in this part: from earlier stages, and from itself
    std::vector<std::vector<std::uint32_t>> dies_after(chunks.size() + 1), dies_in_part(chunks.size() + 1);
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
      for (std::size_t statement = chunks.begin[chunk]; statement < chunks.begin[chunk + 1]; ++statement) {
        NodeId id = body_.variables[statement];
        if (last_reader_[id] <= chunk) continue;
        if (is_call_node(plan_, body_, id)) { // its results are contiguous
          Graph const &graph = *plan_.graph;
          chunks.spill_slot[id] = static_cast<std::uint32_t>(chunks.spill_count);
          chunks.spill_count += graph.externals[function_of(graph, graph.nodes[id])].result_count();
          continue;
        }
        chunks.spill_slot[id] = take(own.empty() ? free : own, chunks);
        bool const stays =
            last_reader_[id] < chunks.size() && part_of(chunks, last_reader_[id]) == part_of(chunks, chunk);
        (stays ? dies_in_part : dies_after)[last_reader_[id]].push_back(chunks.spill_slot[id]);
      }
      if (chunk == chunks.stores.first_chunk) { // its stores may still read slots that die here
        for (NodeId const id : chunks.stores.copied) {
          chunks.copy_slot[id] = take(own.empty() ? free : own, chunks);
          dies_in_part[last_array_reader_[id]].push_back(chunks.copy_slot[id]);
        }
      }
      own.insert(own.end(), dies_in_part[chunk].begin(), dies_in_part[chunk].end());
      of_stage.insert(of_stage.end(), dies_after[chunk].begin(), dies_after[chunk].end());
      bool const ends = chunk + 1 == chunks.size();
      if (ends || part_of(chunks, chunk) != part_of(chunks, chunk + 1)) move_all(own, of_stage);
      if (ends || stage_of(chunks, chunk) != stage_of(chunks, chunk + 1)) move_all(of_stage, free);
    }
  }

  static std::uint32_t take(std::vector<std::uint32_t> &from, Chunks &chunks) {
    if (from.empty()) return static_cast<std::uint32_t>(chunks.spill_count++);
    std::uint32_t const slot = from.back();
    from.pop_back();
    return slot;
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
  ChunkLimits const &limits_;
  std::vector<std::uint32_t> chunk_;             // per variable and gate: the chunk that sets it
  std::vector<std::uint32_t> last_reader_;       // per variable and gate: the last chunk that reads it
  std::vector<std::uint32_t> last_array_reader_; // the last chunk that reads the node's element of an array
};

} // namespace

std::size_t Chunks::of_check(Check const &check) const {
  if (has_parts()) return size();
  auto after = std::lower_bound(begin.begin() + 1, begin.end(), check.before);
  return static_cast<std::size_t>(after - begin.begin()) - 1;
}

Chunks cut(Schedule const &plan, FunctionBody const &body, bool in_compute, ChunkLimits const &limits) {
  return Cutter(plan, body, in_compute, limits).cut();
}

} // namespace symreal
