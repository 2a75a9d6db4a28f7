#include "engine/plan/text/statement_reader.h"

#include "engine/plan/schedule/dependences.h"
#include "engine/plan/schedule/schedule.h"

namespace symreal {

StatementReader::StatementReader(Plan &plan, PlanFunction &function, NodeNames const &names, std::vector<char> computed)
    : plan_(plan),
      graph_(*plan.graph),
      function_(function),
      names_(names),
      computed_(std::move(computed)),
      is_set_(graph_.nodes.size(), 0),
      is_nested_(graph_.nodes.size(), 0) {}

bool StatementReader::read(std::string const &head, Line &line) {
  if (head == "region")
    read_region(line);
  else if (head == "gate")
    read_gate(line);
  else if (head == info(Op::sin).name)
    read_circle(Op::sin, line);
  else if (head == info(Op::cos).name)
    read_circle(Op::cos, line);
  else if (head == "set")
    read_set(line);
  else if (head == "check")
    read_check(line);
  else if (head == "part")
    read_part(line);
  else if (head == "store")
    read_store(line);
  else
    return false;
  return true;
}

void StatementReader::finish(Line &line) {
  if (!function_.parts.empty() && function_.parts.back().end != function_.variables.size())
    line.error("the last statements are in no part");
  if (info(function_.kind).guards != GuardExit::none && function_.checks.size() != graph_.guards.size())
    line.error("the graph has guards that are not checked");
  switch (info(function_.kind).fills) {
  case Array::constants:
    plan_.constant_slot = constant_slots(graph_, function_.results);
    plan_.constant_count = function_.results.size();
    break;
  case Array::computed_angle:
    plan_.angles.computed = function_.results.size();
    if (function_.results.empty()) line.error("function angles computes an angle");
    break;
  default: require_results(line);
  }
  if (is_compute() && angles_ != plan_.angles.size()) line.error("a computed angle has neither sine nor cosine");
}

std::vector<char> StatementReader::computed() const {
  std::vector<char> result = is_set_;
  for (std::size_t id = 0; id < result.size(); ++id) result[id] = result[id] || is_nested_[id];
  return result;
}

void StatementReader::read_region(Line &line) {
  if (line.count("region") != function_.regions.regions.size()) line.error("regions must follow each other from 1 on");
  std::vector<Literal> literals;
  while (!line.done()) {
    std::string word = line.word("a condition");
    bool const holds = word[0] != '!';
    literals.push_back({value(line, holds ? word : word.substr(1)), holds});
    NodeId const condition = literals.back().condition;
    if (!function_.regions.is_gate(condition)) require_number(line, condition);
  }
  function_.regions.regions.push_back(std::move(literals));
}

void StatementReader::read_gate(Line &line) {
  if (line.count("gate") != function_.regions.gates.size()) line.error("gates must follow each other from 0 on");
  std::vector<RegionId> alternatives;
  if (line.accept("any"))
    while (!line.done()) alternatives.push_back(read_region_use(line));
  function_.regions.gates.push_back(std::move(alternatives));
}

// Reads a node that is an element of `sine` or `cosine`, whose angles follow each other: inputs in order, then those
// that function `angles` computes.
void StatementReader::read_circle(Op op, Line &line) {
  if (!is_compute() || !function_.variables.empty()) line.error("compute begins with sines and cosines");
  std::size_t const index = line.count("angle");
  NodeId const id = names_.find(line, line.word("a node")), angle = graph_.nodes[id].operand[0];
  Node const &node = graph_.nodes[id];
  if (node.op != op) line.error("the node is another operation");
  if (plan_.element(id) || (!computed_.empty() && computed_[id])) line.error("the node is computed before compute");
  if (!graph_.node_exact.empty() && graph_.node_exact[id]) line.error("exact operations are calls of the library");
  if (index != angles_ && index + 1 != angles_) line.error("angles must follow each other from 0 on");
  Angles &angles = plan_.angles;
  bool fits = false;
  if (Node const &input = graph_.nodes[angle]; input.op == Op::input) {
    bool const follows = index == angles.inputs.size() && (index == 0 || angles.inputs.back() < input.slot());
    if (index == angles_ && follows) angles.inputs.push_back(input.slot());
    fits = index < angles.inputs.size() && angles.inputs[index] == input.slot();
  } else if (PlanFunction const *const helper = plan_.find(FunctionKind::angles)) {
    std::size_t const result = index - angles.inputs.size();
    fits = index >= angles.inputs.size() && result < helper->results.size() && helper->results[result] == angle;
  }
  if (!fits) line.error("the angle is another one");
  angles_ = index + 1;
  angles.element.resize(graph_.nodes.size(), no_slot);
  angles.element[id] = static_cast<std::uint32_t>(index);
}

void StatementReader::read_kind(Line &line, NodeId id) const {
  std::string const name = line.word("the kind of value");
  std::optional<ValueKind> const kind = find_value_kind(name);
  if (!kind) line.error("'" + name + "' is not a kind of value");
  if (*kind != plan_.kind(function_, id))
    line.error("the value is of kind " + std::string(name_of(plan_.kind(function_, id))));
}

void StatementReader::read_set(Line &line) {
  NodeId const id = value(line, line.word("a node"));
  bool const is_gate = function_.regions.is_gate(id);
  if (is_gate) gates_.resize(function_.regions.gates.size());
  char &is_set = is_gate ? gates_[id - function_.regions.node_count] : is_set_[id];
  if (is_set) line.error("this is set already");
  if (!is_gate) require_statement(line, id);
  read_kind(line, id);
  RegionId const region = line.accept("in") ? read_region_use(line) : everywhere;
  for (Literal const &literal : function_.regions.literals(region)) require_set(line, literal.condition);
  for_each_operand(plan_, function_, id, [&](NodeId use) { require_set(line, use); });
  if (line.accept("returned")) {
    if (!is_call_node(plan_, function_, id) || returned_count(id) == 0) line.error("only a call returns something");
    function_.wanted_returns.insert(id);
  }
  is_set = 1;
  function_.variables.push_back(id);
  function_.region.push_back(region);
}

void StatementReader::read_check(Line &line) {
  if (info(function_.kind).guards == GuardExit::none) line.error("compute checks the guards");
  std::size_t const guard = line.count("guard");
  if (guard != function_.checks.size() || guard >= graph_.guards.size())
    line.error("the guards of the graph must follow each other from 0 on");
  NodeId const condition = graph_.guards[guard].condition;
  require_set(line, condition);
  function_.checks.push_back({condition, function_.variables.size()});
}

void StatementReader::read_part(Line &line) {
  std::vector<ThreadPart> &parts = function_.parts;
  if (!is_compute()) line.error("threads share compute");
  std::size_t const stage = line.count("stage"), begin = parts.empty() ? 0 : parts.back().end;
  std::size_t const next = parts.empty() ? 0 : parts.back().stage + std::size_t{1};
  if (stage != next && stage + 1 != next) line.error("stages must follow each other from 0 on");
  if (function_.variables.size() == begin) line.error("a part has a statement");
  if (!line.accept("of")) line.error("'of' is missing");
  unsigned const threads = line.count("number of threads");
  if (threads < 2 || threads > most_threads) line.error("2 threads at least share an evaluation, and 64 at most");
  if (!parts.empty() && threads != plan_.threads) line.error("all parts are for as many threads");
  if (!line.accept("threads")) line.error("'threads' is missing");
  plan_.threads = threads;
  parts.push_back({static_cast<std::uint32_t>(stage), function_.variables.size()});
  if (!waits_for_other_parts(plan_, function_, parts.size() - 1)) return;
  line.error("the part needs what another part of its stage computes");
}

void StatementReader::read_store(Line &line) {
  if (info(function_.kind).fills == Array::output) line.error("compute stores what the graph says");
  if (line.count("slot") != function_.results.size()) line.error("slots must follow each other from 0 on");
  NodeId const id = value(line, line.word("a node"));
  if (function_.regions.is_gate(id)) line.error("a gate is not a number");
  if (graph_.nodes[id].is_constant()) line.error("a constant needs no slot");
  if (function_.kind != FunctionKind::preprocess || !is_wide(graph_.nodes[id].op)) require_number(line, id);
  require_set(line, id);
  function_.results.push_back(id);
}

std::size_t StatementReader::returned_count(NodeId call) const {
  return graph_.externals[function_of(graph_, graph_.nodes[call])].returned_count();
}

void StatementReader::require_number(Line const &line, NodeId id) const {
  Op const op = graph_.nodes[id].op;
  if (!is_leaf(op) && info(op).has(flag::STRUCTURE | flag::WIDE)) line.error("this is not a number");
}

void StatementReader::require_statement(Line const &line, NodeId id) const {
  if (graph_.nodes[id].op == Op::argument) line.error("a list of arguments is part of its call");
  if (is_nested_[id]) line.error("a statement above has computed this for itself: set it before that");
  require_visible(line, id);
}

void StatementReader::require_visible(Line const &line, NodeId id) const {
  Node const &node = graph_.nodes[id];
  if (!reads_elements(function_.kind) && node.attribute == Attribute::variable)
    line.error("preprocess sees no inputs, which this depends on");
  if (reads_elements(function_.kind) && node.op == Op::parameter && !plan_.element(id))
    line.error("compute sees no parameters, but what preprocess stores");
}

RegionId StatementReader::read_region_use(Line &line) const {
  RegionId const region = line.count("region");
  if (region >= function_.regions.regions.size()) line.error("no region above has this number");
  return region;
}

NodeId StatementReader::value(Line &line, std::string const &word) const {
  if (word[0] != '?') return names_.find(line, word);
  std::optional<NodeId> const number = parse_natural(std::string_view(word).substr(1)); // possibly a gate set later
  if (!number || *number >= no_node - function_.regions.node_count)
    line.error("'" + word + "' is not a node of the graph");
  return function_.regions.node_count + *number;
}

void StatementReader::require_set(Line &line, NodeId use) {
  auto const is_above = [&](NodeId id) {
    if (!function_.regions.is_gate(id)) return is_set_[id] != 0;
    std::size_t const gate = id - function_.regions.node_count;
    if (gate >= gates_.size() || !gates_[gate]) line.error("gate " + std::to_string(gate) + " is not set above");
    return true;
  };
  for_each_read(
      graph_, use, is_above,
      [&](NodeId id) {
        require_visible(line, id);
        Node const &node = graph_.nodes[id];
        if (is_call(node.op)) line.error("a call that this needs is not set above");
        is_nested_[id] = !node.is_constant();
        if (is_read(plan_, function_.kind, id)) return true;
        if (node.op == Op::returned && is_set_[node.operand[0]]) require_returned(line, node);
        return false;
      },
      [](NodeId) {});
}

void StatementReader::require_returned(Line const &line, Node const &node) const {
  NodeId const call = node.operand[0];
  if (result_of(graph_, node) < returned_count(call) && !function_.wanted_returns.contains(call))
    line.error("the call that this needs does not say 'returned'");
}

void StatementReader::require_results(Line &line) {
  for (std::size_t slot = 0; slot < graph_.results.size(); ++slot) {
    NodeId const id = graph_.results[slot];
    Node const &node = graph_.nodes[id];
    if (!is_set_[id] && !node.is_constant() && node.op != Op::returned && !plan_.element(id))
      line.error("result " + std::to_string(slot) + " is not set");
    require_set(line, id);
  }
  if (graph_.last_effect != no_node && !is_set_[graph_.last_effect]) line.error("the last effect is not set");
}

} // namespace symreal
