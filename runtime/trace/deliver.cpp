#include "runtime/trace/deliver.h"

#include "engine/graph/graph_binary.h"
#include "engine/support/number.h"
#include "runtime/trace/report/events.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace symreal::trace {

static void hand_to_driver(Graph const &graph, std::string const &output_file) {
  static std::atomic<unsigned> delivered = 0;
  unsigned number = delivered++;
  std::string const name = std::to_string(number) + ".graph";
  write_binary_graph(record_directory() + "/" + name, graph);
  event({"kernel", graph.kernel, name, output_file});
  for (Frozen const &frozen : graph.frozen) {
    std::string values;
    for (double value : frozen.values) values += (values.empty() ? "" : " ") + shortest(value);
    event({"frozen", graph.kernel, frozen.name, to_string(frozen.place), values, hexadecimal(frozen.stack)});
  }
  flush_events();
  char const *wanted = std::getenv("SYMREAL_KERNELS");
  if (wanted && number + 1 == std::strtoul(wanted, nullptr, 10)) {
    std::fflush(nullptr);
    std::cout.flush();
    _exit(0);
  }
}

void deliver(Graph const &graph, std::string const &output_file) {
  try {
    if (record_directory().empty())
      generate_here(graph, output_file);
    else
      hand_to_driver(graph, output_file);
  } catch (DiagnosticError const &error) {
    report(error.diagnostic());
    give_up();
  } catch (std::bad_alloc const &) {
    report({DiagnosticId::out_of_memory,
            {},
            "the system gives no more memory to hand kernel '" + graph.kernel + "' over"});
    give_up();
  }
}

} // namespace symreal::trace
