#include "tool/commands/sweep.h"

#include "engine/graph/names.h"
#include "tool/calls/driver_program.h"

#include <fmt/format.h>

namespace symreal::tool {
namespace {

// Interface that all members of a family share: objects by role, name and number of extents.
std::vector<std::string> interface_of(Graph const &graph) {
  std::vector<std::string> words;
  auto const add = [&](char const *role, std::vector<Object> const &objects) {
    for (Object const &object : objects)
      words.push_back(fmt::format("{} '{}'{}", role, identifier(object.label),
                                  object.extents.empty() ? "" : fmt::format(" of {} extents", object.extents.size())));
  };
  add("input", graph.inputs);
  add("parameter", graph.parameters);
  add("output", graph.outputs);
  return words;
}

class Family {
public:
  explicit Family(std::string name) : name_(std::move(name)) {}

  void require_member(long size, Graph const &graph) {
    std::vector<std::string> const words = interface_of(graph);
    if (kernel_.empty()) {
      kernel_ = graph.kernel;
      words_ = words;
      first_ = size;
    }
    if (graph.kernel != kernel_)
      refuse(size, fmt::format("kernel '{}'", kernel_), fmt::format("kernel '{}'", graph.kernel));
    for (std::size_t k = 0; k < std::max(words.size(), words_.size()); ++k) {
      std::string const before = k < words_.size() ? words_[k] : "no further object";
      std::string const now = k < words.size() ? words[k] : "no further object";
      if (before != now) refuse(size, before, now);
    }
  }

  [[noreturn]] void refuse(long size, std::string const &before, std::string const &now) const {
    fail(DiagnosticId::sweep_differs, {},
         fmt::format("with {0} = {1} the program has {2}, with {0} = {3} {4}", name_, first_, before, size, now));
  }

private:
  std::string name_, kernel_;
  std::vector<std::string> words_;
  long first_ = 0;
};

Graph single_graph(program::Front &front, SweepSizes const &sizes, long size) {
  if (front.kernels.size() != 1)
    fail(DiagnosticId::sweep_differs, {},
         fmt::format("with {} = {} the program has {} kernels: choose one with --kernel", sizes.name, size,
                     front.kernels.size()));
  return std::move(front.kernels.front().graph);
}

// Records one size; rewrites and builds the program only if the size changes it.
bool record_size(program::FrontRequest request, SweepRequest const &sweep, long size, program::Talk const &talk,
                 program::Front &front) {
  if (sweep.as_argument) request.run.arguments.push_back(std::to_string(size));
  bool const is_built = sweep.as_argument && front.workspace;
  if (!is_built) {
    front = {};
    if (!program::rewrite_sources(request, front, talk) || !program::build_programs(request, front, talk)) return false;
  }
  return program::record_kernels(request, front, talk);
}

} // namespace

bool record_sweep(SweepRequest const &request, Console &console, std::function<void(long size, Graph)> const &take) {
  Family family(request.sizes.name);
  program::Front front;
  for (long const size : request.sizes.values) {
    std::vector<std::string> flags;
    if (!request.as_argument) flags.push_back(fmt::format("-D{}={}", request.sizes.name, size));
    bool is_recorded = false;
    with_driver(request.front(flags), request.calls, console.talk(), console,
                [&](program::FrontRequest const &called, program::Talk const &talk) {
                  is_recorded = record_size(called, request, size, talk, front);
                });
    if (!is_recorded) return false;
    Graph graph = single_graph(front, request.sizes, size);
    family.require_member(size, graph);
    take(size, std::move(graph));
  }
  return true;
}

} // namespace symreal::tool
