#include "program/record/explore.h"

#include "engine/support/progress.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <string_view>
#include <tuple>

namespace symreal::program {
namespace {

constexpr std::string_view explores = "explore:", selects = "auto:", zeros = ":zeros", apart = ":apart",
                           chosen = ":met=";

RecordedPath recorded_path(Graph graph, Events const &events) {
  RecordedPath path{std::move(graph), {}, events.is_cut_off};
  for (DecidedEvent const &one : events.decided)
    path.steps.push_back({static_cast<NodeId>(one.condition), one.outcome, one.is_assumed, one.is_joined, one.text,
                          one.addresses, one.is_by_range});
  return path;
}

[[noreturn]] void fail_to_repeat(Place const &place) {
  fail(DiagnosticId::path_not_repeated, place,
       "with the same outcomes of its decisions the kernel decides on other values");
}

bool is_same(Object const &a, Object const &b) {
  return a.label == b.label && a.extents == b.extents && a.count == b.count && a.members == b.members;
}

// The first object in which two paths differ. A path that is cut off may lack the last objects.
Object const *first_difference(std::vector<Object> const &objects, std::vector<Object> const &others, bool is_cut_off) {
  auto const [here, there] = std::ranges::mismatch(objects, others, is_same);
  if (there != others.end()) return &*there;
  return here == objects.end() || is_cut_off ? nullptr : &*here;
}

// Requires that all paths have the same interface.
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

// Counts the joins on a path, except those on its beginning, which an earlier path shares.
void add_joined(Exploration &exploration, Events const &events, std::optional<Outcomes> const &beginning) {
  if (!beginning) {
    exploration.joins = events.joined.size();
    exploration.joined_at = events.joined_at;
    for (auto const &one : events.joined) exploration.pieces += one.pieces, exploration.joined += one.selects;
  }
  auto const common = static_cast<std::size_t>(beginning ? std::ranges::count(*beginning, 'j') : 0);
  for (std::size_t k = common; k < events.joined.size(); ++k) {
    exploration.zeros += events.joined[k].zeros;
    exploration.by_range += events.joined[k].by_range;
  }
}

} // namespace

std::string path_text(std::size_t kernel, Outcomes const &outcomes, bool is_cut_at_end, ExploreBounds const &bounds,
                      std::size_t pieces) {
  return fmt::format("{}:{}{}:{}{}:{}", kernel, outcomes, is_cut_at_end ? "!" : "", bounds.depth,
                     bounds.zeros ? "z" : "", bounds.joins ? pieces : 0);
}

static std::size_t pieces_left(Exploration const &exploration) {
  std::size_t const all = first_pieces_in_vain + exploration.decided;
  return all - std::min(all, exploration.in_vain);
}

static std::optional<Graph> explore_paths(std::size_t kernel, Place const &place, ExploreBounds const &bounds,
                                          std::function<std::optional<PathRun>(std::string const &)> const &run_path,
                                          ChoosePaths const &choose, Exploration &exploration) {
  PathTree tree;
  Graph first; // interface of the kernel
  std::optional<MetPaths> met;
  std::optional<Outcomes> outcomes = Outcomes();
  Progress progress("paths");
  for (std::size_t tried = 0; outcomes;) {
    exploration.paths_left = tried == bounds.paths;
    if (exploration.paths_left) break;
    std::optional<PathRun> run = run_path(path_text(kernel, *outcomes, false, bounds, pieces_left(exploration)));
    if (!run) return std::nullopt;
    bool const has_ended = !run->graph, is_late = has_ended && run->is_late;
    if (has_ended && tried == 0 && !met) fail_to_repeat(place); // the program's own path has reached the end before
    if (has_ended) {                                            // rerun up to the last decision before its end
      if (run->taken.size() < outcomes->size() || run->taken.empty()) fail_to_repeat(place);
      run = run_path(path_text(kernel, run->taken, true, bounds, 0));
      if (!run) return std::nullopt;
      if (!run->graph) fail_to_repeat(place);
    }
    Graph &graph = *run->graph;
    if (graph.last_effect != no_node && !run->events.decided.empty())
      fail(DiagnosticId::effect_on_path, place,
           fmt::format("the kernel decides on values and calls '{}', which has an effect",
                       std::ranges::find(graph.externals, false, &External::pure)->name));
    bool const is_cut_off = run->events.is_cut_off;
    if (tried == 0) {
      first = without_nodes(graph);
      if (!met) met = choose(graph);
    }
    require_same_interface(first, graph, is_cut_off, place);
    RecordedPath path = recorded_path(std::move(graph), run->events);
    if (met) met->note(path);
    if (std::optional<Outcomes> corrected = met ? MetPaths::correction(path) : std::nullopt) {
      outcomes = std::move(corrected);
      continue;
    }
    ++(is_late      ? exploration.late
       : has_ended  ? exploration.ended
       : is_cut_off ? exploration.cut_off
                    : exploration.paths);
    exploration.followed += run->events.followed;
    exploration.in_vain += run->events.in_vain;
    exploration.decided += run->events.decided.size();
    exploration.beyond += run->events.beyond;
    add_joined(exploration, run->events, tried == 0 ? std::nullopt : outcomes);
    if (!tree.add(std::move(path))) fail_to_repeat(place);
    ++tried;
    progress.add();
    outcomes = tree.next();
  }
  Graph graph = tree.merge();
  exploration.selects = tree.selects();
  exploration.open = tree.open_branches();
  exploration.unmet = tree.unmet();
  exploration.samples = met ? met->samples() : 0;
  exploration.zeros += tree.assumed();
  exploration.by_range += tree.assumed_by_range();
  exploration.explored = tree.decided_at();
  exploration.guards = graph.guards.size();
  return graph;
}

std::optional<Graph> explore(std::size_t kernel, Place const &place, ExploreBounds const &bounds,
                             std::function<std::optional<PathRun>(std::string const &)> const &run_path,
                             ChoosePaths const &choose, Exploration &exploration) {
  try {
    return explore_paths(kernel, place, bounds, run_path, choose, exploration);
  } catch (DiagnosticError const &error) { // joins may fail to repeat, or exceed the time limit
    if (error.diagnostic().id != DiagnosticId::path_not_repeated || !bounds.joins) throw;
    exploration = {};
    ExploreBounds without = bounds;
    without.joins = false;
    return explore_paths(kernel, place, without, run_path, choose, exploration);
  }
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
  if (exploration.paths_left) note(fmt::format("there are more than {} paths (--explore=paths)", bounds.paths));
  if (exploration.cut_off != 0)
    note(fmt::format("{} cut off beyond {} decisions (--explore=depth)", paths(exploration.cut_off), bounds.depth));
  if (exploration.beyond != 0)
    note(fmt::format("the path of this run has {} more than {} decisions (--explore=depth)", exploration.beyond,
                     bounds.depth));
  if (exploration.ended != 0)
    note(fmt::format("on {} the program ends before the kernel does", paths(exploration.ended)));
  if (exploration.late != 0)
    note(fmt::format("on {} the program did not come to the kernel's end in time", paths(exploration.late)));
  return {std::move(warning)};
}

std::vector<DecidedPlace> decided_places(Graph const &graph, std::vector<Place> const &explored,
                                         std::vector<Place> const &joined) {
  auto const order = [](Place const &a, Place const &b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
  };
  std::map<Place, DecidedPlace, decltype(order)> all(order);
  auto const at = [&](LocationId location) -> DecidedPlace * {
    Place const place = place_at(graph, location);
    return place.file.empty() ? nullptr : &all[place];
  };
  for (Place const &place : explored) all[place].is_explored = true;
  for (Place const &place : joined) all[place].is_joined = true;
  for (Guard const &guard : graph.guards)
    if (DecidedPlace *const place = at(guard.location)) place->is_guarded = true;
  for (std::size_t id = 0; id < graph.node_location.size(); ++id) // selects between paths stand where the paths part
    if (DecidedPlace *const place = graph.nodes[id].op == Op::select ? at(graph.node_location[id]) : nullptr)
      place->is_selected = !place->is_explored && !place->is_joined;
  std::vector<DecidedPlace> places;
  for (auto &[place, decided] : all) {
    decided.place = place;
    if (decided.is_selected || decided.is_explored || decided.is_joined || decided.is_guarded)
      places.push_back(decided);
  }
  return places;
}

std::optional<ExploreBounds> explore_bounds(std::string const &decisions) {
  ExploreBounds bounds;
  bounds.selects = decisions.starts_with(selects);
  if (!bounds.selects && !decisions.starts_with(explores)) return std::nullopt;
  char const *const end = decisions.data() + decisions.size();
  char const *const numbers = decisions.data() + (bounds.selects ? selects : explores).size();
  char const *const colon = std::from_chars(numbers, end, bounds.paths).ptr;
  if (colon != end) std::from_chars(colon + 1, end, bounds.depth);
  bounds.zeros = decisions.find(zeros) != decisions.npos;
  bounds.joins = decisions.find(apart) == decisions.npos;
  if (std::size_t const at = decisions.find(chosen); at != decisions.npos)
    bounds.met = decisions.substr(at + chosen.size());
  return bounds;
}

std::string explore_policy(ExploreBounds const &bounds) {
  return fmt::format("{}{}:{}{}{}{}", bounds.selects ? selects : explores, bounds.paths, bounds.depth,
                     bounds.zeros ? zeros : "", bounds.joins ? "" : apart,
                     bounds.met.empty() ? "" : std::string(chosen) + bounds.met);
}

} // namespace symreal::program
