#include "engine/plan/schedule/chunks.h"

#include "engine/graph/graph.h"
#include "engine/plan/schedule/dependences.h"

#include <algorithm>
#include <deque>
#include <numeric>
#include <utility>

namespace symreal {

namespace {

// Cut points of a long function body.
class Cuts {
public:
  Cuts(Plan const &plan, PlanFunction const &body) : loaded_by_(body.variables.size(), nowhere) {
    std::vector<std::uint32_t> statement(body.regions.value_count(), nowhere),
        last_reader(body.variables.size(), nowhere);
    auto const end = static_cast<std::uint32_t>(body.variables.size());
    reads_.all.reserve(2 * std::size_t{end});
    dying_.all.reserve(end);
    for (std::uint32_t k = 0; k < end; ++k) {
      auto const note = [&](NodeId use) {
        for_each_read(
            *plan.graph, use, [&](NodeId id) { return statement[id] != nowhere; },
            [&](NodeId id) { return is_read(plan, body.kind, id); },
            [&](NodeId id) {
              reads_.all.push_back(statement[id]);
              last_reader[statement[id]] = k;
            });
      };
      for (Literal const &literal : body.regions.literals(body.region[k])) note(literal.condition);
      for_each_operand(plan, body, body.variables[k], note);
      statement[body.variables[k]] = k;
      reads_.end_row();
    }
    for (std::uint32_t k = 0; k < end; ++k) {
      for (std::uint32_t const read : reads_[k])
        if (std::exchange(last_reader[read], last_reader[read] == k ? nowhere : last_reader[read]) == k)
          dying_.all.push_back(read);
      dying_.end_row();
    }
  }

  // Begins of the chunks of these statements. A chunk has at most `most_statements` and, except for the last, at least
  // half as many; it ends where the fewest values per statement cross its borders. Linear time.
  std::vector<std::size_t> between(std::size_t first, std::size_t end, std::size_t most_statements) {
    std::vector<std::size_t> begins;
    while (first < end) {
      begins.push_back(first);
      bool const is_long = end - first > most_statements;
      first = is_long ? best_end(first, most_statements) : end;
    }
    return begins;
  }

private:
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0}; // statements are fewer than nodes

  std::size_t best_end(std::size_t begin, std::size_t most_statements) {
    constexpr std::size_t unknown = ~std::size_t{0};
    auto const chunk = static_cast<std::uint32_t>(begin);
    std::size_t best = begin + most_statements, best_cost = unknown, loaded = 0, stored = 0;
    for (std::size_t k = begin; k < begin + most_statements; ++k) {
      for (std::uint32_t const read : reads_[k])
        if (read < begin && std::exchange(loaded_by_[read], chunk) != chunk) ++loaded;
      ++stored; // whether or not it is read
      for (std::uint32_t const dying : dying_[k])
        if (dying >= begin) --stored;
      std::size_t const length = k + 1 - begin, cost = loaded + stored;
      if (length < most_statements / 2) continue;
      if (best_cost != unknown && cost * (best - begin) > best_cost * length) continue;
      best = k + 1;
      best_cost = cost;
    }
    return best;
  }

  // Per statement: the earlier statements whose values it reads, and those that it reads last.
  StatementRows reads_, dying_;
  std::vector<std::uint32_t> loaded_by_; // per statement: begin of the last chunk found to read it
};

class Cutter {
public:
  Cutter(Plan const &plan, PlanFunction const &body, ChunkLimits const &limits)
      : plan_(plan),
        body_(body),
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
    Cuts cuts(plan_, body_);
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
    if (!body_.regions.is_gate(id) && is_read(plan_, body_.kind, id)) note_array_read(id, chunk);
    for_each_operand(plan_, body_, id, [&](NodeId operand) { note_read(operand, chunk); });
  }

  void note_read(NodeId use, std::size_t chunk) {
    auto const is_set = [&](NodeId id) { return chunk_[id] != no_slot; };
    for_each_read(
        *plan_.graph, use, [&](NodeId id) { return is_set(id) || is_read(plan_, body_.kind, id); },
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
      share_out_stores(chunks);
    } else {
      store_behind(chunks);
    }
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (std::size_t const result : chunks.stores.of_chunk[chunk]) note_read(body_.results[result], chunk);
    for (std::size_t const result : chunks.stores.behind) note_read(body_.results[result], chunks.size());
  }

  // Assigns the stores, at most `most_statements` per chunk.
  void share_out_stores(Chunks &chunks) const {
    Stores &stores = chunks.stores;
    stores.first_chunk = first_storing_chunk(chunks);
    for (std::size_t id = 0; id < plan_.graph->nodes.size(); ++id)
      if (last_array_reader_[id] != no_slot && last_array_reader_[id] > stores.first_chunk)
        stores.copied.push_back(static_cast<NodeId>(id));
    std::vector<std::vector<std::size_t>> ready(chunks.size());
    for (std::size_t result = 0; result < body_.results.size(); ++result) ready[ready_in(result)].push_back(result);
    std::deque<std::size_t> waiting;
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
      std::vector<std::size_t> &own = stores.of_chunk.emplace_back(std::move(ready[chunk]));
      std::size_t const room = chunk < stores.first_chunk ? 0 : limits_.most_statements;
      while (own.size() > room) {
        waiting.push_back(own.back());
        own.pop_back();
      }
      while (own.size() < room && !waiting.empty()) {
        own.push_back(waiting.front());
        waiting.pop_front();
      }
    }
    stores.behind.assign(waiting.begin(), waiting.end());
    std::ranges::sort(stores.behind);
  }

  // Variable that holds a result: for a result of a call, the call.
  NodeId variable(std::size_t result) const {
    NodeId const id = body_.results[result];
    bool const is_returned = plan_.graph->nodes[id].op == Op::returned && chunk_[id] == no_slot;
    return is_returned ? plan_.graph->nodes[id].operand[0] : id;
  }
  // Chunk in which a result is ready; 0 for a constant.
  std::size_t ready_in(std::size_t result) const {
    std::uint32_t const chunk = chunk_[variable(result)];
    return chunk == no_slot ? 0 : chunk;
  }

  std::size_t first_storing_chunk(Chunks const &chunks) const {
    std::size_t first_allowed = 0; // behind the guards
    for (Check const &check : body_.checks) first_allowed = std::max(first_allowed, chunks.of_check(check));
    // Differences, by chunk, of the number of values that wait if that chunk stores first.
    std::vector<std::ptrdiff_t> more(chunks.size() + 1, 0);
    std::vector<char> counted(chunk_.size(), 0);
    for (std::size_t result = 0; result < body_.results.size(); ++result) {
      NodeId const id = variable(result);
      bool const is_kept_anyway = last_reader_[id] > ready_in(result);
      if (chunk_[id] == no_slot || counted[id] || is_kept_anyway) continue;
      counted[id] = 1;
      ++more[ready_in(result) + 1];
    }
    for (std::uint32_t const reader : last_array_reader_) {
      if (reader == no_slot) continue;
      ++more[0];
      --more[reader];
    }
    std::ptrdiff_t waiting = 0, fewest = 0;
    std::size_t best = chunks.size();
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
      waiting += more[chunk];
      if (chunk < first_allowed || (best != chunks.size() && waiting >= fewest)) continue;
      best = chunk;
      fewest = waiting;
    }
    return best;
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

  Plan const &plan_;
  PlanFunction const &body_;
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

Chunks cut(Plan const &plan, PlanFunction const &body, ChunkLimits const &limits) {
  return Cutter(plan, body, limits).cut();
}

} // namespace symreal
