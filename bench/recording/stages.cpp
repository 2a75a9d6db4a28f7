// Times of the stages behind a recording: stages GRAPH OUTPUT.c [ROUNDS]
//
// GRAPH is what a symbolic program left for its driver. A line a stage and round, separated by tabs: the stage, seconds
// of the processor, operations, megabytes: the most that this process held during the stage. Before them what the
// program executed, and how many nodes the graph has.
#include "engine/emit/emit.h"
#include "engine/graph/graph_binary.h"
#include "engine/optimise/passes/pass.h"
#include "engine/support/files.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

using namespace symreal;

namespace {

std::size_t operations(Graph const &graph) {
  std::size_t count = 0;
  for (Node const &node : graph.nodes) count += !is_leaf(node.op);
  return count;
}

// The kernel counts anew from here.
void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
  return 0;
}

double seconds_of_processor() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// `count` gives the operations of what the stage made.
template <class Run, class Count> void stage(std::string const &name, Run const &run, Count const &count) {
  forget_peak();
  double const start = seconds_of_processor();
  run();
  double const seconds = seconds_of_processor() - start;
  std::printf("%s\t%.6f\t%zu\t%.1f\n", name.c_str(), seconds, count(), peak_megabytes());
}

void round(std::string const &recording, std::string const &output) {
  Graph graph;
  auto const count = [&] { return operations(graph); };
  stage("read", [&] { graph = read_binary_graph(recording); }, count);
  std::size_t executed = 0;
  for (std::size_t const each : graph.executed.by_op) executed += each;
  std::printf("executed\t0\t%zu\t0\nnodes\t0\t%zu\t0\n", executed, graph.nodes.size());
  for (std::string const &name : default_passes()) {
    if (!find_pass(name).runs_in(FloatingPoint::finite)) continue;
    std::size_t const before = operations(graph);
    stage(
        name, [&] { graph = run_passes(std::move(graph), {&name, 1}, FloatingPoint::finite); }, [&] { return before; });
  }
  Plan plan{};
  stage("schedule", [&] { plan = schedule(graph); }, count);
  std::vector<EmittedFile> files;
  stage("emit", [&] { files = emit(plan, *find_language("c"), {.base_name = "kernel"}); }, count);
  stage("write", [&] { write_if_changed(output, files.front().text); }, count);
}

} // namespace

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  int const rounds = argc > 3 ? std::atoi(argv[3]) : 1;
  for (int k = 0; k < rounds; ++k) round(argv[1], argv[2]);
}
