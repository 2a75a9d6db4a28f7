#include "engine/plan/schedule/stores.h"

#include <algorithm>
#include <deque>

namespace symreal {

namespace {

class Distribution {
public:
  Distribution(Graph const &graph, FunctionBody const &body, ChunkReads const &reads)
      : graph_(graph),
        body_(body),
        reads_(reads) {}

  Stores run(std::size_t most) {
    Stores stores{first_chunk(), {}, std::vector<std::vector<std::size_t>>(reads_.chunk_count), {}};
    for (std::size_t id = 0; id < graph_.nodes.size(); ++id)
      if (is_read_behind(id, stores.first_chunk)) stores.copied.push_back(static_cast<NodeId>(id));
    std::vector<std::vector<std::size_t>> ready(reads_.chunk_count);
    for (std::size_t result = 0; result < body_.results.size(); ++result) ready[ready_in(result)].push_back(result);
    std::deque<std::size_t> waiting;
    for (std::size_t chunk = 0; chunk < reads_.chunk_count; ++chunk) {
      std::vector<std::size_t> &own = stores.of_chunk[chunk];
      own = std::move(ready[chunk]);
      std::size_t const room = chunk < stores.first_chunk ? 0 : most;
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
    return stores;
  }

private:
  bool is_read_behind(std::size_t id, std::size_t chunk) const {
    return reads_.last_array_reader[id] != ChunkReads::never && reads_.last_array_reader[id] > chunk;
  }

  // Variable that holds a result: for a result of a call, the call.
  NodeId variable(std::size_t result) const {
    NodeId const id = body_.results[result];
    bool const is_returned = graph_.nodes[id].op == Op::returned && reads_.set_in[id] == ChunkReads::never;
    return is_returned ? graph_.nodes[id].operand[0] : id;
  }
  // Chunk in which a result is ready; 0 for a constant.
  std::size_t ready_in(std::size_t result) const {
    std::uint32_t const chunk = reads_.set_in[variable(result)];
    return chunk == ChunkReads::never ? 0 : chunk;
  }

  std::size_t first_chunk() const {
    // Differences, by chunk, of the number of values that wait if that chunk stores first.
    std::vector<std::ptrdiff_t> more(reads_.chunk_count + 1, 0);
    std::vector<char> counted(reads_.set_in.size(), 0);
    for (std::size_t result = 0; result < body_.results.size(); ++result) {
      NodeId const id = variable(result);
      bool const is_kept_anyway = reads_.last_reader[id] > ready_in(result);
      if (reads_.set_in[id] == ChunkReads::never || counted[id] || is_kept_anyway) continue;
      counted[id] = 1;
      ++more[ready_in(result) + 1];
    }
    for (std::uint32_t const reader : reads_.last_array_reader) {
      if (reader == ChunkReads::never) continue;
      ++more[0];
      --more[reader];
    }
    std::ptrdiff_t waiting = 0, fewest = 0;
    std::size_t best = reads_.chunk_count;
    for (std::size_t chunk = 0; chunk < reads_.chunk_count; ++chunk) {
      waiting += more[chunk];
      if (chunk < reads_.first_storing || (best != reads_.chunk_count && waiting >= fewest)) continue;
      best = chunk;
      fewest = waiting;
    }
    return best;
  }

  Graph const &graph_;
  FunctionBody const &body_;
  ChunkReads const &reads_;
};

} // namespace

Stores distribute(Graph const &graph, FunctionBody const &body, ChunkReads const &reads, std::size_t most) {
  return Distribution(graph, body, reads).run(most);
}

} // namespace symreal
