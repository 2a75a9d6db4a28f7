#include "tool/html/groups.h"

namespace symreal::tool {

namespace {

constexpr std::size_t none = ~std::size_t{0};

std::string file_of(std::string const &path) { return path.substr(path.rfind('/') + 1); }

} // namespace

std::size_t Groups::of(NodeId node) {
  Op const op = graph_.nodes[node].op;
  if (op == Op::input) return group("inputs", none, none, 0);
  if (op == Op::parameter) return group("parameters", none, none, 0);
  LocationId const location = node < graph_.node_location.size() ? graph_.node_location[node] : no_location;
  if (location == no_location || graph_.locations[location].places.empty())
    return group(std::string(info(op).name), none, none, 0);
  auto const found = by_location_.find(location);
  return found != by_location_.end() ? found->second : by_location_[location] = place_group(location);
}

std::size_t Groups::place_group(LocationId location) {
  Place const &place = graph_.locations[location].places.front();
  std::optional<std::size_t> const known = sources_.number_of(place.file);
  internal_check(known.has_value()); // all files of the graph are known
  std::size_t const file = *known;
  std::string const function = sources_.function_at(file, place.line);
  std::size_t const parent = group(function.empty() ? file_of(place.file) : function, none, file, 0);
  return group(file_of(place.file) + ":" + std::to_string(place.line), parent, file, place.line);
}

std::size_t Groups::group(std::string const &label, std::size_t parent, std::size_t file, unsigned line) {
  auto const [entry, is_new] = numbers_.try_emplace({parent, label, file, line}, data_.size());
  if (!is_new) return entry->second;
  data_.push_back({{"label", label}});
  if (parent != none) data_.back()["parent"] = parent;
  if (file != none) data_.back()["file"] = file;
  if (line != 0) data_.back()["line"] = line;
  return entry->second;
}

} // namespace symreal::tool
