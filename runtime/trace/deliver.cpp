#include "trace/deliver.h"

#include "differentiate/differentiate.h"
#include "emit/emit.h"
#include "emit/language/banner.h"
#include "graph/frozen.h"
#include "graph/graph_binary.h"
#include "passes/pass.h"
#include "support/files.h"
#include "support/number.h"
#include "trace/report/events.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
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

// As --frozen would decide, which is $SYMREAL_FROZEN here.
static void report_frozen(Graph const &graph) {
  char const *wanted = std::getenv("SYMREAL_FROZEN");
  std::string const policy = wanted ? wanted : "state";
  for (Frozen const &state : graph.frozen)
    if (std::optional<Severity> const severity = frozen_severity(state, policy))
      report({DiagnosticId::frozen_state, state.place, frozen_message(graph.kernel, state), {}, *severity});
}

static void generate_here(Graph const &graph, std::string const &output_file) {
  report_frozen(graph);
  if (anything_wrong()) give_up(); // what is wrong is printed; nothing is generated
  std::vector<std::string> const passes = default_passes();
  Graph const wanted = differentiate(graph, graph.wishes, [](Diagnostic const &warning) { report(warning); });
  std::filesystem::path const path = output_file.empty() ? graph.kernel + ".c" : output_file;
  Graph const optimised = run_passes(wanted, passes, FloatingPoint::finite);
  std::vector<EmittedFile> const files =
      emit(schedule(optimised), *find_language("c"), {.base_name = path.stem().string()});
  for (EmittedFile const &file : files) require_ours((path.parent_path() / file.name).string(), file.text);
  for (EmittedFile const &file : files) write_if_changed((path.parent_path() / file.name).string(), file.text);
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
