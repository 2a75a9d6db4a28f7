#include "tool/html/graph_data.h"

#include "engine/analysis/figures/figures.h"
#include "engine/graph/graph.h"
#include "engine/graph/graph_text.h"
#include "engine/graph/names.h"
#include "engine/support/number.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace symreal::tool {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    for (unsigned i = 0; i < 4; ++i) text += at + i > bytes.size() ? '=' : digits[group >> (18 - 6 * i) & 63];
  }
  return text;
}

// Compact text of many numbers: base64 of bytes, each number with seven bits a byte.
class PackedNumbers {
public:
  void add(std::uint64_t number) { // lowest bits first; the top bit of a byte: more bytes follow
    for (; number >= 128; number >>= 7) bytes_ += static_cast<char>((number & 127) | 128);
    bytes_ += static_cast<char>(number);
  }
  std::string text() const { return base64(bytes_); }

private:
  std::string bytes_;
};

constexpr std::size_t none = ~std::size_t{0};

std::string file_of(std::string const &path) { return path.substr(path.rfind('/') + 1); }

// Groups that the picture of a graph collapses: nodes by source line, lines by function.
class Groups {
public:
  Groups(Graph const &graph, Sources const &sources) : graph_(graph), sources_(sources) {}

  // Group of a node, created on first use. Without a place: inputs, parameters, or the operation's name.
  std::size_t of(NodeId node);
  // [{"label": "dynamics.cpp:40", "parent": 3, "file": 0, "line": 40}, ...]; the parent is a function's group.
  Json const &data() const { return data_; }

private:
  std::size_t place_group(LocationId location);
  std::size_t group(std::string const &label, std::size_t parent, std::size_t file, unsigned line);

  Graph const &graph_;
  Sources const &sources_;
  std::map<LocationId, std::size_t> by_location_;
  std::map<std::tuple<std::size_t, std::string, std::size_t, unsigned>, std::size_t> numbers_;
  Json data_ = Json::array();
};

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

// Distinct constants, in order of first use.
class Constants {
public:
  std::size_t number(double value) {
    auto const [entry, is_new] = numbers_.emplace(shortest(value), values_.size());
    if (is_new) values_.push_back(entry->first);
    return entry->second;
  }
  Json const &values() const { return values_; }

private:
  std::map<std::string, std::size_t> numbers_;
  Json values_ = Json::array();
};

// Number in node_data of each node of the graph, or no_node.
std::vector<NodeId> shown_numbers(Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  std::vector<NodeId> numbers(graph.nodes.size(), no_node);
  NodeId next = 0;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !graph.nodes[id].is_constant()) numbers[id] = next++;
  return numbers;
}

} // namespace

Json node_data(Graph const &graph, Figures const &figures, Sources const &sources) {
  std::vector<NodeId> const shown = shown_numbers(graph), lines = line_numbers(graph);
  std::vector<std::string> const inputs = element_names(graph.inputs), parameters = element_names(graph.parameters);
  Groups groups(graph, sources);
  Constants constants;
  std::string ops;
  PackedNumbers operands, group, line, name;
  Json leaves = Json::array();
  std::uint64_t count = 0, last_line = 0;
  for (NodeId id = 0; id < graph.nodes.size(); ++id) {
    if (shown[id] == no_node) continue;
    Node const &node = graph.nodes[id];
    ops += static_cast<char>(node.op);
    group.add(groups.of(id));
    line.add(lines[id] - last_line);
    last_line = lines[id];
    name.add(id < graph.node_name.size() && graph.node_name[id] != no_name ? graph.node_name[id] + 1 : 0);
    if (is_leaf(node.op)) {
      leaves.push_back((node.op == Op::input ? inputs : parameters)[node.slot()]);
    } else {
      for (unsigned i = 0; i < arity(node.op); ++i) {
        Node const &operand = graph.nodes[node.operand[i]];
        operands.add(operand.is_constant() ? 2 * constants.number(operand.value()) + 1
                                           : 2 * std::uint64_t{count - shown[node.operand[i]]});
      }
    }
    ++count;
  }
  Json table = Json::object();
  for (OperationInfo const &row : operations())
    table[std::to_string(static_cast<unsigned>(row.op))] = {row.name, row.arity};
  for (Op leaf : {Op::input, Op::parameter})
    table[std::to_string(static_cast<unsigned>(leaf))] = {leaf == Op::input ? "input" : "parameter", 0};
  Json results = Json::array(), path = Json::array();
  std::vector<std::string> const outputs = element_names(graph.outputs);
  for (std::size_t slot = 0; slot < graph.results.size(); ++slot)
    if (shown[graph.results[slot]] != no_node) results.push_back({shown[graph.results[slot]], outputs[slot]});
  for (PathStep const &step : figures.critical_path) path.push_back(shown[step.node]);
  return {{"count", count},
          {"table", std::move(table)},
          {"ops", base64(ops)},
          {"operands", operands.text()},
          {"constants", constants.values()},
          {"leaves", std::move(leaves)},
          {"group", group.text()},
          {"groups", groups.data()},
          {"line", line.text()},
          {"name", name.text()},
          {"names", graph.names},
          {"results", std::move(results)},
          {"critical_path", std::move(path)}};
}

Json timetable_data(Graph const &graph, ScheduleReport const &report, std::vector<NodeId> const &node_of_task) {
  Timetable const &table = report.solution->timetable;
  TaskGraph const &tasks = report.input->tasks;
  std::vector<NodeId> const shown = shown_numbers(graph);
  std::vector<std::vector<TaskId>> by_unit(report.units->name.size());
  for (TaskId task = 0; task < tasks.size(); ++task)
    if (tasks.duration[task] != 0) by_unit[table.unit[task]].push_back(task);
  Json json = summary_json(report);
  for (std::size_t unit = 0; unit < by_unit.size(); ++unit) {
    std::ranges::stable_sort(by_unit[unit], {}, [&](TaskId task) { return table.start[task]; });
    PackedNumbers wait, duration, node;
    Time end = 0;
    for (TaskId task : by_unit[unit]) {
      wait.add(static_cast<std::uint64_t>(table.start[task] - end));
      duration.add(static_cast<std::uint64_t>(tasks.duration[task]));
      node.add(shown[node_of_task[task]]);
      end = table.start[task] + tasks.duration[task];
    }
    json["units"][unit].update(
        {{"tasks", by_unit[unit].size()}, {"wait", wait.text()}, {"duration", duration.text()}, {"node", node.text()}});
  }
  return json;
}

} // namespace symreal::tool
