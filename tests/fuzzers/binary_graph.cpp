// A graph as a symbolic program hands it over. One that is taken is written as text, and read again.
#include "engine/graph/graph_binary.h"
#include "fuzzer.h"
#include "temporary_file.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  fuzz::TemporaryFile const file(fuzz::text_of(data, size)), again("");
  Graph graph;
  if (!fuzz::takes([&] { graph = read_binary_graph(file.path()); })) return 0;
  write_binary_graph(again.path(), graph);
  Graph const same = read_binary_graph(again.path());
  internal_check(same.nodes == graph.nodes && same.results == graph.results);
  return 0;
}
