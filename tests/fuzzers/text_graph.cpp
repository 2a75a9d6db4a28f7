// A graph as text. One that is taken is written and read again, and goes through the passes of each mode into C.
#include "engine/emit/emit.h"
#include "engine/graph/graph_text.h"
#include "engine/optimise/passes/pass.h"
#include "fuzzer.h"

using namespace symreal;

int LLVMFuzzerTestOneInput(std::uint8_t const *data, std::size_t size) {
  Graph graph;
  if (!fuzz::takes([&] { graph = read_graph(fuzz::text_of(data, size), "input"); })) return 0;
  fuzz::check_round_trip(graph, write_graph, [](std::string const &text) { return read_graph(text, "written"); });
  for (FloatingPoint const mode : {FloatingPoint::strict, FloatingPoint::finite, FloatingPoint::fast})
    fuzz::takes([&] {
      Graph const optimised = run_passes(graph, default_passes(), PassSettings(mode, 1));
      emit(schedule(optimised), *find_language("c"), {.base_name = "kernel"});
    });
  return 0;
}
