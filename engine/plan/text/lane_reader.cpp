#include "engine/plan/text/lane_reader.h"

#include "engine/plan/lanes/check.h"
#include "engine/plan/lanes/lanes.h"

#include <cctype>

namespace symreal {

LaneReader::LaneReader(Plan const &plan, PlanFunction &function, NodeNames const &names, Line &line)
    : plan_(plan),
      graph_(*plan.graph),
      names_(names),
      lanes_(function.lanes.emplace()) {
  if (function.kind != FunctionKind::compute || plan.has_loops()) line.error("compute has vectors, if no loops");
  if (plan.threads > 1) line.error("threads share out statements, which vectors hold several of");
  if (std::string const why = obstacle_to_lanes(plan); !why.empty()) line.error("compute has no vectors: " + why);
  lanes_.width = line.count("number of lanes");
  if (lanes_.width != 2 && lanes_.width != 4 && lanes_.width != 8) line.error("vectors have 2, 4 or 8 lanes");
  lanes_.operations = line.count("number of operations");
  lanes_.in_lanes = line.count("number of operations");
  lanes_.lane.resize(graph_.nodes.size());
}

bool LaneReader::read(std::string const &head, Line &line) {
  if (head == "vector")
    read_vector(line);
  else if (head == "compute")
    read_item(line);
  else if (head == "store")
    read_vector_store(line);
  else
    return false;
  return true;
}

void LaneReader::read_vector(Line &line) {
  using Form = lanes::Vector::Form;
  auto const id = static_cast<lanes::VectorId>(lanes_.vectors.size());
  std::string const name = line.word("the form of a vector");
  lanes::Vector vector;
  auto const form = find_name<Form>(lanes::form_names, name);
  std::optional<Op> const op = find_operation(name);
  if (!form && (!op || arity(*op) > 2)) line.error("'" + name + "' is not a form of a vector");
  vector.form = form.value_or(Form::operation);
  if (op) vector.op = *op;
  if (vector.form == Form::load) read_load(line, vector);
  std::size_t operands = 0;
  while (!line.done() && operands < 2 && std::isdigit(static_cast<unsigned char>(line.peek()[0])))
    vector.operand[operands++] = read_vector_use(line, id);
  if (vector.form == Form::operation ? operands != arity(vector.op)
      : vector.form == Form::shuffle ? operands == 0
                                     : operands != 0)
    line.error("the vector has another number of operands");
  if (line.accept("subtracts"))
    for (std::size_t lane = 0; lane < lanes_.width; ++lane) vector.subtracts.push_back(line.count("sign") != 0);
  if (vector.form == Form::shuffle) {
    if (!line.accept("takes")) line.error("'takes' is missing");
    for (std::size_t lane = 0; lane < lanes_.width; ++lane) {
      vector.from.push_back(line.count("lane"));
      if (vector.from.back() >= operands * lanes_.width) line.error("an operand has no such lane");
    }
  }
  if (!line.accept(":")) line.error("':' is missing");
  for (std::uint32_t lane = 0; lane < lanes_.width; ++lane) vector.nodes.push_back(read_lane(line, vector, id, lane));
  lanes_.vectors.push_back(std::move(vector));
}

void LaneReader::read_load(Line &line, lanes::Vector &vector) const {
  std::string const name = line.word("an array");
  std::optional<Array> const array = find_array(name);
  if (!array || !reads(FunctionKind::compute, *array)) line.error("compute reads no array '" + name + "'");
  vector.array = *array;
  vector.first = line.count("first element");
  if (vector.first + lanes_.width > plan_.extent(vector.array)) line.error("the vector is beyond its array");
}

NodeId LaneReader::read_lane(Line &line, lanes::Vector const &vector, lanes::VectorId id, std::uint32_t lane) {
  std::string word = line.word("a node");
  if (word == "-") {
    if (vector.form != lanes::Vector::Form::load) line.error("only elements that a load passes over hold no node");
    return no_node;
  }
  bool const is_elsewhere = word[0] == '~';
  NodeId const node = names_.find(line, is_elsewhere ? word.substr(1) : word);
  if (vector.form != lanes::Vector::Form::operation || is_elsewhere) return node;
  if (lanes_.lane[node].is_given()) line.error("a lane above computes this");
  lanes_.lane[node] = {id, lane};
  return node;
}

lanes::VectorId LaneReader::read_vector_use(Line &line, lanes::VectorId before) const {
  lanes::VectorId const id = line.count("vector");
  if (id >= before) line.error("no vector above has this number");
  return id;
}

void LaneReader::read_item(Line &line) {
  bool const is_vector = line.accept("vector");
  auto const count = static_cast<lanes::VectorId>(lanes_.vectors.size());
  std::uint32_t const id = is_vector ? read_vector_use(line, count) : names_.find(line, line.word("a node"));
  if (!is_vector && (is_leaf(graph_.nodes[id].op) || lanes_.lane[id].is_given()))
    line.error("a scalar operation is one that no lane computes");
  lanes_.order.push_back({is_vector, id});
}

void LaneReader::read_vector_store(Line &line) {
  if (!line.accept("vector")) line.error("'vector' is missing");
  lanes::VectorId const id = read_vector_use(line, static_cast<lanes::VectorId>(lanes_.vectors.size()));
  if (!line.accept("at")) line.error("'at' is missing");
  std::size_t const first = line.count("first result");
  if (first + lanes_.width > graph_.results.size()) line.error("the vector is beyond the results");
  lanes_.stores.push_back({id, first});
}

void LaneReader::finish(Line const &line) const {
  lanes::ScalarFunction const function(plan_, lanes_.width);
  if (std::string const difference = lanes::find_difference(function, lanes_); !difference.empty())
    line.error("the vectors compute something else: " + difference);
}

} // namespace symreal
