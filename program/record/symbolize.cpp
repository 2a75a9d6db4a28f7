#include "program/record/symbolize.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <llvm/DebugInfo/Symbolize/Symbolize.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <map>
#include <tuple>

namespace symreal::program {

struct Symbolizer::Engine {
  llvm::symbolize::LLVMSymbolizer symbolizer;

  static llvm::symbolize::LLVMSymbolizer::Options options() {
    llvm::symbolize::LLVMSymbolizer::Options options;
    // Paths as the overlay's #line directives spell them.
    options.PathStyle = llvm::DILineInfoSpecifier::FileLineInfoKind::RelativeFilePath;
    options.RelativeAddresses = true;
    options.UseSymbolTable = false;
    return options;
  }
  Engine() : symbolizer(options()) {}
};

Symbolizer::Symbolizer(std::string executable, Overlay const &overlay)
    : executable_(std::move(executable)),
      overlay_(overlay),
      engine_(std::make_unique<Engine>()) {}
Symbolizer::~Symbolizer() = default;

// Is this a frame of RealNumber or the recorder, which carries no information? Inlined functions have short names, so
// files count, too.
static bool is_runtime(llvm::DILineInfo const &info) {
  std::string_view const file = info.FileName;
  return info.FunctionName.starts_with("symreal::") || file.find("/runtime/trace/") != file.npos ||
         file.find("/include/symreal/") != file.npos;
}

// Name of the function in the user's program.
static std::string original_name(std::string function) {
  constexpr std::string_view real = "symreal::types::RealNumber";
  for (std::size_t at; (at = function.find(real)) != function.npos;) function.replace(at, real.size(), "double");
  constexpr std::string_view renamed = "symreal_"; // prefix of C names that are keywords of C++
  if (function.starts_with(renamed)) function.erase(0, renamed.size());
  return function;
}

std::vector<Frame> Symbolizer::frames(std::vector<std::uint64_t> const &return_addresses) {
  std::vector<Frame> frames;
  for (std::uint64_t address : return_addresses) {
    if (address == 0) continue;
    // The byte before the return address lies within the call.
    llvm::object::SectionedAddress call{address - 1, llvm::object::SectionedAddress::UndefSection};
    auto found = engine_->symbolizer.symbolizeInlinedCode(executable_, call);
    if (!found) {
      llvm::consumeError(found.takeError());
      continue;
    }
    for (unsigned i = 0; i < found->getNumberOfFrames(); ++i) {
      llvm::DILineInfo const &info = found->getFrame(i);
      if (info.FileName == llvm::DILineInfo::BadString || info.Line == 0) continue;
      if (is_runtime(info) && !overlay_.contains(info.FileName)) continue;
      if (info.FunctionName.find("::symreal_members(") != info.FunctionName.npos) continue;
      Place place{info.FileName, info.Line, info.Column};
      frames.push_back({original_name(info.FunctionName), overlay_.original(place), overlay_.contains(info.FileName)});
    }
  }
  return frames;
}

namespace {

std::string key(Location const &location) {
  std::string text;
  for (Place const &place : location.places) text += to_string(place) + '\n';
  return text;
}

// Merges locations that denote the same places: several pieces of code may share one.
void merge_equal_locations(Graph &graph) {
  std::vector<Location> merged;
  std::vector<LocationId> now;
  std::map<std::string, LocationId> known;
  for (Location &location : graph.locations) {
    auto [found, is_new] = known.try_emplace(key(location), static_cast<LocationId>(merged.size()));
    now.push_back(found->second);
    if (is_new) merged.push_back(std::move(location));
  }
  graph.locations = std::move(merged);
  auto move = [&](LocationId &id) { id = id == no_location ? id : now[id]; };
  for (LocationId &id : graph.node_location) move(id);
  for (Guard &guard : graph.guards) move(guard.location);
}

using Position = std::tuple<std::string, unsigned, unsigned>;

Position position(Place const &place) { return {place.file, place.line, place.column}; }

// Finds the innermost statement around a place: the one that begins last, since statements nest or are disjoint.
class Statements {
public:
  explicit Statements(std::vector<rewrite::NamedStatement> const &statements) {
    for (rewrite::NamedStatement const &statement : statements) by_begin_[position(statement.begin)] = &statement;
  }

  rewrite::NamedStatement const *around(Place const &place) const {
    constexpr int most_nested = 8; // nesting of assignments in values
    auto at = by_begin_.upper_bound(position(place));
    for (int i = 0; i < most_nested && at != by_begin_.begin(); ++i) {
      --at;
      if (position(at->second->end) >= position(place)) return at->second;
    }
    return nullptr;
  }

private:
  std::map<Position, rewrite::NamedStatement const *> by_begin_;
};

} // namespace

void resolve(Graph &graph, Symbolizer &symbolizer) {
  for (Location &location : graph.locations) {
    std::vector<Frame> frames = symbolizer.frames(location.addresses);
    auto own = std::find_if(frames.begin(), frames.end(), [](Frame const &frame) { return frame.rewritten; });
    if (own != frames.end()) location.places.push_back(own->place);
    for (auto frame = frames.begin(); frame != own; ++frame) location.places.push_back(frame->place);
    location.addresses.clear();
  }
  merge_equal_locations(graph);
}

void name_nodes(Graph &graph, std::vector<rewrite::NamedStatement> const &all) {
  if (graph.node_location.empty()) return;
  Statements const statements(all);
  std::vector<rewrite::NamedStatement const *> by_location;
  for (Location const &location : graph.locations)
    by_location.push_back(location.places.empty() ? nullptr : statements.around(location.places.front()));

  std::map<std::string, NameId> known;
  graph.node_name.assign(graph.nodes.size(), no_name);
  auto statement_of = [&](std::size_t id) -> rewrite::NamedStatement const * {
    LocationId location = graph.node_location[id];
    return location == no_location ? nullptr : by_location[location];
  };
  rewrite::NamedStatement const *following = nullptr; // statement of the following operation
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (is_leaf(graph.nodes[id].op)) continue;
    rewrite::NamedStatement const *statement = statement_of(id);
    if (statement && statement != following) {
      auto [found, is_new] = known.try_emplace(statement->name, static_cast<NameId>(graph.names.size()));
      if (is_new) graph.names.push_back(statement->name);
      graph.node_name[id] = found->second;
    }
    following = statement;
  }
}

} // namespace symreal::program
