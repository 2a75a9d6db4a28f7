// Policy explore: runs the program once for each path through a kernel's decisions and merges the paths into one graph.
//
//   first run ─▶ path ─▶ tree ──next outcomes──▶ run ─▶ path ─▶ tree ─ ... ─▶ one graph
#pragma once

#include "program/record/events.h"
#include "program/record/met_paths.h"
#include "program/record/path_tree.h"
#include "rewrite/facts/result.h"

#include <cstddef>
#include <functional>
#include <string>

namespace symreal::program {

struct ExploreBounds {
  std::size_t paths = 128; // paths of a kernel
  std::size_t depth = 64;  // decisions on a path
  bool selects = false;    // policy auto: selects instead of paths where the source permits
  bool zeros = false;      // treat tests for exact zero as decisions
  bool joins = true;       // merge branches that join again into one path
  std::string met = {};    // hash of the table whose samples choose the paths
};

// Treatment of the decisions at one place of the source.
struct DecidedPlace {
  Place place;
  bool is_selected = false, is_explored = false, is_joined = false, is_guarded = false;
};

// Statistics of a kernel's exploration.
struct Exploration {
  std::size_t paths = 0;    // paths that reach the kernel's end
  std::size_t cut_off = 0;  // paths cut off at the depth
  std::size_t ended = 0;    // paths on which the program ends before the kernel
  std::size_t late = 0;     // paths on which the kernel exceeds the time limit
  std::size_t followed = 0; // decisions implied by earlier ones
  std::size_t selects = 0;  // selects between paths, before any pass
  std::size_t joins = 0;    // decisions whose branches join, on the first path
  std::size_t pieces = 0;   // pieces of runs, between decisions, that these joins took
  std::size_t in_vain = 0;  // pieces of failed attempts at a join, on all paths
  std::size_t decided = 0;  // decisions on all paths
  std::size_t joined = 0;   // selects at joins
  std::size_t open = 0;     // branches that no recorded path takes; a guard each
  std::size_t samples = 0;  // samples that choose the paths
  std::size_t unmet = 0;    // branches that no sample takes; a guard each
  std::size_t beyond = 0;   // decisions beyond the depth on the path of the program's own values; a guard each
  std::size_t zeros = 0;    // tests for exact zero that are taken as not met; a guard each
  std::size_t by_range = 0; // conditions outside the range of an input; a guard each
  std::size_t guards = 0;   // all guards, including those that pragmas request
  bool paths_left = false;  // the limit on paths left some unexplored
  std::vector<std::vector<std::uint64_t>> explored = {};  // call stacks of explored decisions
  std::vector<std::vector<std::uint64_t>> joined_at = {}; // call stacks of decisions whose branches join
  std::vector<DecidedPlace> places = {};                  // under policy auto

  // Does the graph cover all paths, except exact zeros and guards that pragmas request?
  bool is_complete() const { return open == 0 && beyond == 0; }
};

// Entry `path` of the request for a path of the K-th kernel. Failed attempts at joins may take `pieces` pieces.
std::string path_text(std::size_t kernel, Outcomes const &outcomes, bool is_cut_at_end, ExploreBounds const &bounds,
                      std::size_t pieces);

// Pieces that failed attempts at joins may take before the first path is recorded. Each decision on the paths then adds
// one: so the attempts take no longer than the paths and these pieces.
inline constexpr std::size_t first_pieces_in_vain = 2000;

// One run of the program along a path: its events, and the recorded graph if the run reached the kernel's end.
struct PathRun {
  Events events;
  std::optional<Graph> graph = {};
  Outcomes taken = {};  // outcomes taken, however the program ended
  bool is_late = false; // exceeded the time limit
  double seconds = 0;
};

// Chooses the paths of a kernel, once its inputs are known; nullopt to explore all.
using ChoosePaths = std::function<std::optional<MetPaths>(Graph const &)>;

// Explores the K-th kernel of a run. `run_path` runs the program with this entry `path`; it returns nullopt after
// reporting an error, and then so does this function. Throws if the program does not repeat itself.
std::optional<Graph> explore(std::size_t kernel, Place const &place, ExploreBounds const &bounds,
                             std::function<std::optional<PathRun>(std::string const &)> const &run_path,
                             ChoosePaths const &choose, Exploration &exploration);

// Warns which branches are guards, and why; empty if all branches are code.
std::vector<Diagnostic> open_branches(rewrite::Kernel const &kernel, Exploration const &exploration,
                                      ExploreBounds const &bounds);

// Decided places in source order; requires resolved locations. `explored`: places where paths part. `joined`: places of
// decisions whose branches join again.
std::vector<DecidedPlace> decided_places(Graph const &graph, std::vector<Place> const &explored,
                                         std::vector<Place> const &joined);

// Parses --decisions with its bounds: "explore:128:64", "explore:128:64:zeros:apart", "auto:128:64:met=HASH". Nullopt
// for another policy.
std::optional<ExploreBounds> explore_bounds(std::string const &decisions);
std::string explore_policy(ExploreBounds const &bounds);

} // namespace symreal::program
