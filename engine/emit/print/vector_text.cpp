#include "engine/emit/print/vector_text.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal {

using lanes::Vector;
using lanes::VectorId;

// Nesting limits, as for scalar expressions.
static constexpr unsigned most_nested_operations = 12, most_nested_depth = 6;

VectorText::VectorText(Emission const &emission, lanes::LaneFunction const &function)
    : emission_(emission),
      language_(emission.language),
      function_(function),
      is_variable_(function.vectors.size(), 0),
      names_(function.vectors.size()) {
  choose_variables();
  std::size_t number = 0;
  for (lanes::Item const &item : function.order)
    if (item.is_vector && is_variable(item.id)) names_[item.id] = fmt::format("p{}", number++);
}

// Vectors with variables: stored, taken apart, shuffled, used more than once, or too large to nest. Constants and
// splats are printed at their use.
void VectorText::choose_variables() {
  std::vector<Vector> const &vectors = function_.vectors;
  std::vector<unsigned> uses(vectors.size(), 0), size(vectors.size(), 0), depth(vectors.size(), 0);
  auto const fix = [&](VectorId id) { is_variable_[id] = 1; };
  for (lanes::Store const &store : function_.stores) fix(store.vector);
  for (lanes::Item const &item : function_.order) {
    if (!item.is_vector) {
      for (NodeId operand : emission_.graph().nodes[item.id].operand)
        if (operand != no_node && function_.lane[operand].is_given()) fix(function_.lane[operand].vector);
      continue;
    }
    Vector const &vector = vectors[item.id];
    for (VectorId operand : vector.operand) {
      if (operand == lanes::no_vector) continue;
      ++uses[operand];
      if (vector.form == Vector::Form::shuffle) fix(operand);
    }
    if (vector.form == Vector::Form::build)
      for (NodeId node : vector.nodes)
        if (function_.lane.size() > node && function_.lane[node].is_given()) fix(function_.lane[node].vector);
  }
  for (std::size_t slot = 0; slot < emission_.graph().results.size(); ++slot) {
    lanes::Lane const &lane = function_.lane[emission_.graph().results[slot]];
    if (lane.is_given() && function_.is_stored_alone(slot)) fix(lane.vector);
  }
  for (Guard const &guard : emission_.graph().guards)
    if (function_.lane[guard.condition].is_given()) fix(function_.lane[guard.condition].vector);
  for (lanes::Item const &item : function_.order) {
    if (!item.is_vector) continue;
    VectorId const id = item.id;
    Vector const &vector = vectors[id];
    bool const in_place = vector.form == Vector::Form::splat || vector.form == Vector::Form::constants;
    if (in_place) continue;
    size[id] = vector.form == Vector::Form::operation ? 1 : 0;
    for (VectorId operand : vector.operand) {
      if (operand == lanes::no_vector || is_variable(operand)) continue;
      size[id] += size[operand];
      depth[id] = std::max(depth[id], depth[operand] + 1);
    }
    if (uses[id] != 1 || size[id] > most_nested_operations || depth[id] > most_nested_depth) fix(id);
  }
}

std::string VectorText::with_width(std::string_view pattern) const {
  return fill(language_, pattern, {{"width", std::to_string(function_.width)}});
}

std::string VectorText::lane(lanes::Lane const &lane) const {
  return fill(language_, language_.vectors.lane, {{"name", names_[lane.vector]}, {"lane", std::to_string(lane.lane)}});
}

static std::string place(std::string const &array, std::size_t index) {
  return index == 0 ? array : fmt::format("{} + {}", array, index);
}

std::string VectorText::store(lanes::Store const &store, std::string const &array) const {
  return fill(language_, language_.vectors.store,
              {{"width", std::to_string(function_.width)},
               {"place", place(array, store.first)},
               {"value", names_[store.vector]}});
}

std::set<std::string> VectorText::names() const {
  std::set<std::string> names(names_.begin(), names_.end());
  names.erase("");
  names.insert(type());
  return names;
}

class VectorText::Printer {
public:
  Printer(VectorText const &text, std::function<std::string(NodeId)> const &use, std::vector<NodeId> &computed)
      : text_(text),
        use_(use),
        computed_(computed) {}

  // The vector as an expression; choose_variables bounds its nesting.
  Text spelled_out(VectorId id) {
    Vector const &vector = vectors()[id];
    switch (vector.form) {
    case Vector::Form::operation: return operation(vector);
    case Vector::Form::load:
      return {fill(
          language(), language().vectors.load,
          {{"width", std::to_string(width())}, {"place", place(std::string(name_of(vector.array)), vector.first)}})};
    case Vector::Form::shuffle: {
      VectorId const second = vector.operand[1] == lanes::no_vector ? vector.operand[0] : vector.operand[1];
      return {fill(language(), language().vectors.shuffle,
                   {{"x", text_.names_[vector.operand[0]]},
                    {"y", text_.names_[second]},
                    {"lanes", fmt::format("{}", fmt::join(vector.from, ", "))}})};
    }
    case Vector::Form::constants:
    case Vector::Form::splat:
    case Vector::Form::build: break;
    }
    std::vector<std::string> values;
    for (NodeId node : vector.nodes) values.push_back(use_(node));
    return build(values);
  }

private:
  Language const &language() const { return text_.language_; }
  std::vector<Vector> const &vectors() const { return text_.function_.vectors; }
  std::size_t width() const { return text_.function_.width; }

  Text build(std::vector<std::string> const &values) const {
    return {fill(language(), language().vectors.build,
                 {{"width", std::to_string(width())}, {"values", fmt::format("{}", fmt::join(values, ", "))}})};
  }

  // Whether a number can replace the vector beside another vector.
  bool is_number(VectorId id) const {
    Vector const &vector = vectors()[id];
    if (text_.is_variable(id)) return false;
    if (vector.form == Vector::Form::splat) return true;
    if (vector.form != Vector::Form::constants) return false;
    Nodes const &nodes = text_.emission_.graph().nodes;
    return std::ranges::all_of(vector.nodes, [&](NodeId node) { return nodes[node] == nodes[vector.nodes[0]]; });
  }
  Text operand(VectorId id, bool as_number) {
    if (text_.is_variable(id)) return {text_.names_[id]};
    if (!as_number || !is_number(id)) return spelled_out(id);
    std::string text = use_(vectors()[id].nodes[0]);
    return {text, text.starts_with('-') ? binding::unary : 0};
  }

  Text operation(Vector const &vector) {
    computed_.insert(computed_.end(), vector.nodes.begin(), vector.nodes.end());
    if (arity(vector.op) == 1) return apply(vector.op, {operand(vector.operand[0], false)});
    bool const both = is_number(vector.operand[0]) && is_number(vector.operand[1]);
    Text const x = operand(vector.operand[0], !both || !vector.subtracts.empty()), y = operand(vector.operand[1], true);
    if (vector.subtracts.empty()) return apply(vector.op, {x, y});
    std::vector<std::string> signs; // exact in every lane, and safe from fusion
    for (char const subtracts : vector.subtracts) signs.push_back(constant(language(), subtracts ? -1 : 1));
    return apply(Op::add, {x, apply(Op::mul, {build(signs), y})});
  }

  Text apply(Op op, std::vector<Text> const &operands) const {
    Spellings::Spelling const &spelling = text_.emission_.spellings[op];
    Text result{.text = {}, .precedence = spelling.precedence};
    for (Spellings::Piece const &piece : spelling.pieces) {
      if (piece.operand < 0) {
        result.text += piece.text;
        continue;
      }
      auto const &[text, precedence] = operands[static_cast<std::size_t>(piece.operand)];
      result.text += precedence != 0 && precedence < piece.binding ? "(" + text + ")" : text;
    }
    return result;
  }

  VectorText const &text_;
  std::function<std::string(NodeId)> const &use_;
  std::vector<NodeId> &computed_;
};

std::string VectorText::value(VectorId id, std::function<std::string(NodeId)> const &use,
                              std::vector<NodeId> &computed) const {
  return Printer(*this, use, computed).spelled_out(id).text;
}

} // namespace symreal
