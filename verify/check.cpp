#include "verify/check.h"

#include "engine/graph/implicit.h"
#include "engine/optimise/differentiate/rules.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <llvm/Demangle/Demangle.h>

namespace symreal::program {
namespace {

// The graph completed by the functions that dual numbers and derivative formulas call; nullopt if it needs none.
std::optional<Graph> with_derivative_functions(Graph const &graph, Banner const &banner) {
  bool const has_implicit = std::ranges::any_of(graph.externals, is_implicit);
  if (!has_implicit && (banner.derivatives.empty() || !calls_program(graph))) return std::nullopt;
  std::optional<Graph> completed(without_implicit(graph));
  if (!banner.derivatives.empty()) add_derivative_functions(*completed);
  return completed;
}

} // namespace

Subject::Subject(Front const &front, RunOptions const &run, Recorded const &recorded, std::string const &path,
                 Banner const &banner, VerificationOptions const &options)
    : front(front),
      run(run),
      recorded(recorded),
      path(path),
      banner(banner),
      options(options),
      completed_(with_derivative_functions(recorded.graph, banner)),
      changeable_(front.workspace->file("changeable")),
      graph(completed_ ? *completed_ : recorded.graph),
      code(path, banner, graph, {}, *front.build.cache, *front.workspace),
      in_program(code.needs_program()),
      original_program(has_original() ? front.original_program : front.replay_program),
      later_calls(graph, banner.mode, options.seed,
                  [this](Sample const &sample) { return code.run(with_seeds(sample.inputs), sample.parameters); }) {
  std::ofstream(changeable_) << fmt::format("{}\n", fmt::join(front.rewritten.changeable, "\n"));
  original = start("the original", original_program, in_program ? &code : nullptr);
}

std::unique_ptr<Replay> Subject::start(char const *what, std::string const &executable, GeneratedCode const *with,
                                       std::string const &profile) const {
  wire::Request request;
  std::string const &others = recorded.kernel.signature.redefinition.result.others;
  if (!options.wrapper.empty() && !others.empty()) request.set(wire::Entry::returned, others);
  request.set(wire::Entry::changeable, changeable_);
  if (options.fork_each) request.set(wire::Entry::replay_alone, "1");
  return std::make_unique<Replay>(what, executable, run, recorded.begun_as, graph, *front.workspace, with, profile,
                                  std::move(request));
}

std::vector<double> Subject::with_seeds(std::vector<double> inputs) const {
  inputs.insert(inputs.end(), seeds.begin(), seeds.end());
  return inputs;
}

void add_left(std::vector<LeftState> &all, std::string const &name) {
  for (LeftState &one : all)
    if (one.name == name) return void(++one.samples);
  all.push_back({name, 1});
}

// Objects on the stack and the heap are told apart by place only.
std::string describe(replay::LeftBehind const &left) {
  switch (left.region) {
  case memory::Region::static_object: return "'" + llvm::demangle(left.name) + "'";
  case memory::Region::heap_block: return fmt::format("a block of {} bytes on the heap", left.size);
  case memory::Region::stack: return "a variable of a calling function";
  }
  return {};
}

bool contains(std::vector<replay::LeftBehind> const &all, replay::LeftBehind const &left) {
  return std::ranges::find(all, left) != all.end();
}

bool all_near(std::vector<double> const &one, std::vector<double> const &other, FloatingPoint mode, double tolerance) {
  return std::ranges::equal(one, other, [&](double a, double b) { return same(a, b, mode, tolerance); });
}

bool all_same(std::vector<double> const &one, std::vector<double> const &other) {
  return all_near(one, other, FloatingPoint::strict, 0);
}

bool compare_outputs(std::vector<OutputComparison> &outputs, std::size_t number, std::vector<double> const &wanted,
                     std::vector<double> const &found, FloatingPoint mode, double tolerance) {
  bool is_worst = false;
  for (std::size_t slot = 0; slot < outputs.size(); ++slot)
    is_worst |= outputs[slot].add(number, wanted[slot], found[slot], mode, tolerance);
  return is_worst;
}

} // namespace symreal::program
