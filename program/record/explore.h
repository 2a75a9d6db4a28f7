// Policy explore: the program is run once for each path through the decisions of a kernel, and the paths become one
// graph.
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
  std::size_t paths = 128; // of a kernel
  std::size_t depth = 64;  // decisions on a path
  bool selects = false;    // where the source allows it there is a select, and no paths: policy auto
  bool zeros = false;      // tests for exact zero are decisions as any
  bool joins = true;       // ways that come together again are one path
  std::string met = {};    // of the table whose samples choose the paths: its hash
};

// What became of the decisions at one place of the source.
struct DecidedPlace {
  Place place;
  bool is_selected = false, is_explored = false, is_joined = false, is_guarded = false;
};

// What became of a kernel's decisions.
struct Exploration {
  std::size_t paths = 0;    // that come to the kernel's end
  std::size_t cut_off = 0;  // beyond the depth
  std::size_t ended = 0;    // on which the program ends before the kernel does
  std::size_t late = 0;     // on which the kernel does not end in time
  std::size_t followed = 0; // decisions that earlier ones settle
  std::size_t selects = 0;  // between paths, before any pass
  std::size_t joins = 0;    // decisions whose ways come together again, on the first path
  std::size_t pieces = 0;   // of a run, between decisions, that this took
  std::size_t in_vain = 0;  // pieces of attempts at a join that failed, on all paths
  std::size_t decided = 0;  // decisions on all paths
  std::size_t joined = 0;   // selects where they come together
  std::size_t open = 0;     // branches that no recorded path takes: a guard each
  std::size_t samples = 0;  // that were given to choose the paths
  std::size_t unmet = 0;    // branches that none of them takes: a guard each
  std::size_t beyond = 0;   // decisions beyond the depth on the path of the program's own values: a guard each
  std::size_t zeros = 0;    // tests for exact zero that are taken as not met: a guard each
  std::size_t by_range = 0; // conditions beyond the range of an input: a guard each
  std::size_t guards = 0;   // these, and those that pragmas ask for
  bool paths_left = false;  // beyond the number of paths
  std::vector<std::vector<std::uint64_t>> explored = {};  // where the program decides, as addresses
  std::vector<std::vector<std::uint64_t>> joined_at = {}; // the same of decisions whose ways come together
  std::vector<DecidedPlace> places = {};                  // under policy auto

  // Whether the graph is right wherever the program may go, but for exact zeros and guards that pragmas ask for.
  bool is_complete() const { return open == 0 && beyond == 0; }
};

// How a path of the K-th kernel is asked for: $SYMREAL_PATH. Attempts at joins may take so many pieces in vain.
std::string path_variable(std::size_t kernel, Outcomes const &outcomes, bool is_cut_at_end, ExploreBounds const &bounds,
                          std::size_t pieces);

// Pieces of a run that attempts at joins may take in vain before the first path is recorded. Then as many more as there
// are decisions on the paths: so the attempts take no longer than the paths, and these pieces.
inline constexpr std::size_t first_pieces_in_vain = 2000;

// One run of the program along a path: what it told, and what it recorded, if it came so far.
struct PathRun {
  Events events;
  std::optional<Graph> graph = {};
  Outcomes taken = {};  // whatever ended the program
  bool is_late = false; // it took too long
  double seconds = 0;
};

// What chooses the paths of a kernel, once its inputs are known; nothing where all are explored.
using ChoosePaths = std::function<std::optional<MetPaths>(Graph const &)>;

// Explores the K-th kernel of a run. `run_path` runs the program with this $SYMREAL_PATH, or gives nothing if the run
// met an error, which it has reported; then so does this. Fails where the program does not repeat itself.
std::optional<Graph> explore(std::size_t kernel, Place const &place, ExploreBounds const &bounds,
                             std::function<std::optional<PathRun>(std::string const &)> const &run_path,
                             ChoosePaths const &choose, Exploration &exploration);

// A warning that says which branches are guards, and why; nothing where there are none.
std::vector<Diagnostic> open_branches(rewrite::Kernel const &kernel, Exploration const &exploration,
                                      ExploreBounds const &bounds);

// In the order of the source, once the graph's locations are places. `explored`: where paths part. `joined`: where ways
// part that come together again.
std::vector<DecidedPlace> decided_places(Graph const &graph, std::vector<Place> const &explored,
                                         std::vector<Place> const &joined);

// What --decisions has said, with the bounds: "explore:128:64", "explore:128:64:zeros:apart", "auto:128:64:met=HASH".
// Nothing for another policy.
std::optional<ExploreBounds> explore_bounds(std::string const &decisions);
std::string explore_policy(ExploreBounds const &bounds);

} // namespace symreal::program
