// A graph as text. One that is taken is written and read again, and goes through the passes of each mode into C.
#include "emit/emit.h"
#include "fuzzer.h"
#include "graph/graph_text.h"
#include "passes/pass.h"

#include <sstream>

using namespace symreal;

static std::string written(Graph const &graph) {
  std::ostringstream text;
  write_graph(text, graph);
  return text.str();
}

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  Graph graph;
  if (!fuzz::takes([&] { graph = read_graph(fuzz::text_of(data, size), "input"); })) return 0;
  std::string const text = written(graph);
  internal_check(written(read_graph(text, "written")) == text);
  for (FloatingPoint const mode : {FloatingPoint::strict, FloatingPoint::finite, FloatingPoint::fast})
    fuzz::takes([&] {
      Graph const optimised = run_passes(graph, default_passes(), PassSettings(mode, 1));
      emit(schedule(optimised), *find_language("c"), {.base_name = "kernel"});
    });
  return 0;
}
