#include "program/explore.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string_view>

namespace symreal::program {
namespace {

constexpr std::string_view policy = "explore:", zeros = ":zeros";

RecordedPath recorded_path(PathRun run) {
  RecordedPath path{std::move(*run.graph), {}, run.events.is_cut_off};
  for (DecidedEvent &one : run.events.decided)
    path.steps.push_back({static_cast<NodeId>(one.condition), one.outcome, one.is_assumed, one.text, one.addresses});
  return path;
}

[[noreturn]] void fail_to_repeat(Place const &place) {
  fail(DiagnosticId::path_not_repeated, place,
       "with the same outcomes of its decisions the kernel decides on other values");
}

bool is_same(Object const &a, Object const &b) {
  return a.label == b.label && a.extents == b.extents && a.count == b.count && a.members == b.members;
}

// The first object that two paths do not have in common. A path that is cut off may lack the last ones.
Object const *first_difference(std::vector<Object> const &objects, std::vector<Object> const &others, bool is_cut_off) {
  auto const [here, there] = std::ranges::mismatch(objects, others, is_same);
  if (there != others.end()) return &*there;
  return here == objects.end() || is_cut_off ? nullptr : &*here;
}

// Callers see one kernel, whichever path it takes.
void require_same_interface(Graph const &first, Graph const &path, bool is_cut_off, Place const &place) {
  auto const require = [&](char const *kind, std::vector<Object> const &objects, std::vector<Object> const &others) {
    Object const *const other = first_difference(objects, others, is_cut_off);
    if (!other) return;
    fail(DiagnosticId::interface_of_path, other->place.file.empty() ? place : other->place,
         fmt::format("{} '{}' is not the same on every path through kernel '{}'", kind, other->label, first.kernel));
  };
  require("input", first.inputs, path.inputs);
  require("parameter", first.parameters, path.parameters);
  require("output", first.outputs, path.outputs);
}

} // namespace

std::string path_variable(std::size_t kernel, Outcomes const &outcomes, bool is_cut_at_end,
                          ExploreBounds const &bounds) {
  std::string text;
  for (bool outcome : outcomes) text += outcome ? 't' : 'f';
  return fmt::format("SYMREAL_PATH={}:{}{}:{}{}", kernel, text, is_cut_at_end ? "!" : "", bounds.depth,
                     bounds.zeros ? "z" : "");
}

std::optional<Graph> explore(std::size_t kernel, Place const &place, ExploreBounds const &bounds,
                             std::function<std::optional<PathRun>(std::string const &)> const &run_path,
                             Exploration &exploration) {
  PathTree tree;
  Graph first; // its interface
  std::optional<Outcomes> outcomes = Outcomes();
  for (std::size_t tried = 0; outcomes; ++tried, outcomes = tree.next()) {
    exploration.paths_left = tried == bounds.paths;
    if (exploration.paths_left) break;
    std::optional<PathRun> run = run_path(path_variable(kernel, *outcomes, false, bounds));
    if (!run) return std::nullopt;
    bool const has_ended = !run->graph, is_late = has_ended && run->is_late;
    if (has_ended) { // once more, up to the last decision before
      if (run->taken.size() < outcomes->size() || run->taken.empty()) fail_to_repeat(place);
      run = run_path(path_variable(kernel, run->taken, true, bounds));
      if (!run) return std::nullopt;
      if (!run->graph) fail_to_repeat(place);
    }
    if (run->graph->last_effect != no_node && !run->events.decided.empty())
      fail(DiagnosticId::effect_on_path, place,
           fmt::format("the kernel decides on values and calls '{}', which has an effect",
                       std::ranges::find(run->graph->externals, false, &External::pure)->name));
    bool const is_cut_off = run->events.is_cut_off;
    if (tried == 0) first = without_nodes(*run->graph);
    require_same_interface(first, *run->graph, is_cut_off, place);
    ++(is_late      ? exploration.late
       : has_ended  ? exploration.ended
       : is_cut_off ? exploration.cut_off
                    : exploration.paths);
    exploration.followed += run->events.followed;
    exploration.beyond += run->events.beyond;
    if (!tree.add(recorded_path(std::move(*run)))) fail_to_repeat(place);
  }
  Graph graph = tree.merge();
  exploration.selects = tree.selects();
  exploration.open = tree.open_branches();
  exploration.zeros = tree.assumed();
  exploration.guards = graph.guards.size();
  return graph;
}

std::vector<Diagnostic> open_branches(rewrite::Kernel const &kernel, Exploration const &exploration,
                                      ExploreBounds const &bounds) {
  if (exploration.is_complete()) return {};
  auto const paths = [](std::size_t count) { return fmt::format("{} path{}", count, count == 1 ? "" : "s"); };
  std::size_t const guards = exploration.open + exploration.beyond;
  std::string message =
      fmt::format("of kernel '{}' {} {} recorded, and {} guard{} what remains", kernel.name, paths(exploration.paths),
                  exploration.paths == 1 ? "is" : "are", guards, guards == 1 ? " refuses" : "s refuse");
  Diagnostic warning{DiagnosticId::branches_left, kernel.place, std::move(message)};
  if (!kernel.annotations.empty()) warning.place = kernel.annotations.front().place;
  auto const note = [&](std::string text) { warning.notes.push_back({warning.place, std::move(text)}); };
  if (exploration.paths_left) note(fmt::format("there are more than {} paths (--max-paths)", bounds.paths));
  if (exploration.cut_off != 0)
    note(fmt::format("{} cut off beyond {} decisions (--max-depth)", paths(exploration.cut_off), bounds.depth));
  if (exploration.beyond != 0)
    note(fmt::format("the path of this run has {} more than {} decisions (--max-depth)", exploration.beyond,
                     bounds.depth));
  if (exploration.ended != 0)
    note(fmt::format("on {} the program ends before the kernel does", paths(exploration.ended)));
  if (exploration.late != 0)
    note(fmt::format("on {} the program did not come to the kernel's end in time", paths(exploration.late)));
  return {std::move(warning)};
}

std::optional<ExploreBounds> explore_bounds(std::string const &decisions) {
  if (!decisions.starts_with(policy)) return std::nullopt;
  ExploreBounds bounds;
  char const *const end = decisions.data() + decisions.size();
  char const *const colon = std::from_chars(decisions.data() + policy.size(), end, bounds.paths).ptr;
  if (colon != end) std::from_chars(colon + 1, end, bounds.depth);
  bounds.zeros = decisions.ends_with(zeros);
  return bounds;
}

std::string explore_policy(ExploreBounds const &bounds) {
  return fmt::format("{}{}:{}{}", policy, bounds.paths, bounds.depth, bounds.zeros ? zeros : "");
}

} // namespace symreal::program
