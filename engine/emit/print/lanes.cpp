#include "engine/emit/print/body.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/function.h"
#include "engine/plan/schedule/schedule.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace symreal {

namespace {

using lanes::Vector;
using lanes::VectorId;

// Nesting limits, as for scalar expressions.
constexpr unsigned most_nested_operations = 12, most_nested_depth = 6;

std::string address(std::string const &array, std::size_t index) {
  return index == 0 ? array : fmt::format("{} + {}", array, index);
}

// The text of vectors: nested like scalar expressions, with variables for multiple uses.
class VectorText {
public:
  VectorText(Emission const &emission, lanes::LaneFunction const &function)
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

  // Whether the vector has a variable.
  bool is_variable(VectorId id) const { return is_variable_[id] != 0; }
  std::string name(VectorId id) const { return names_[id]; }
  std::string type() const { return with_width(language_.vectors.type); }

  std::string lane(lanes::Lane const &lane) const {
    return fill(language_, language_.vectors.lane,
                {{"name", names_[lane.vector]}, {"lane", std::to_string(lane.lane)}});
  }

  std::string store(lanes::Store const &store, std::string const &array) const {
    return fill(language_, language_.vectors.store,
                {{"width", std::to_string(function_.width)},
                 {"place", address(array, store.first)},
                 {"value", names_[store.vector]}});
  }

  // Value of a vector's variable. `use`: spelling of a node that is scalar or a leaf. Adds the nodes that the text
  // computes to `computed`.
  std::string value(VectorId id, std::function<std::string(NodeId)> const &use, std::vector<NodeId> &computed) const {
    return Printer(*this, use, computed).spelled_out(id).text;
  }

  // All names that the text may use.
  std::set<std::string> names() const {
    std::set<std::string> names(names_.begin(), names_.end());
    names.erase("");
    names.insert(type());
    return names;
  }

private:
  // Text and its binding strength; 0: needs no parentheses.
  struct Text {
    std::string text;
    int precedence = 0;
  };

  // Vectors with variables: stored, taken apart, shuffled, used more than once, or too large to nest. Constants and
  // splats are printed at their use.
  void choose_variables() {
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

  std::string with_width(std::string_view pattern) const {
    return fill(language_, pattern, {{"width", std::to_string(function_.width)}});
  }

  class Printer {
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
        return {fill(language(), language().vectors.load,
                     {{"width", std::to_string(width())},
                      {"place", address(std::string(name_of(vector.array)), vector.first)}})};
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
      Text const x = operand(vector.operand[0], !both || !vector.subtracts.empty()),
                 y = operand(vector.operand[1], true);
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

  Emission const &emission_;
  Language const &language_;
  lanes::LaneFunction const &function_;
  std::vector<char> is_variable_;
  std::vector<std::string> names_; // per vector that is a variable
};

constexpr std::size_t behind_all = ~std::size_t{0};

class LanesPrinter {
public:
  LanesPrinter(Emission &emission, PlanFunction const &function, FunctionNames const &names)
      : emission_(emission),
        language_(emission.language),
        function_(*function.lanes),
        names_(names),
        vectors_(emission, function_),
        rest_(rest()),
        plan_(schedule(rest_)) {
    put_in_order();
  }

  CodeText print() {
    Language whole = language_; // the body is not cut
    whole.functions.most_statements = std::string::npos;
    Emission inner{plan_, whole, emission_.options, vectors_.names()};
    BodyPrinter printer(inner, plan_.compute(), names_.target);
    printer.spell_inputs(leaves_, constant_leaves_);
    CodeText text(language_);
    printer.set_before([&](std::size_t statement, CodeText &out) { print_vectors(statement, printer, out); });
    printer.statements(0, text);
    print_vectors(plan_.compute().variables.size(), printer, text);
    printer.checks(text);
    for (lanes::Store const &store : function_.stores) text.statement(2, vectors_.store(store, names_.target));
    for (std::size_t slot = 0; slot < emission_.graph().results.size(); ++slot)
      if (function_.is_stored_alone(slot))
        text.statement(2, fill(language_, language_.statements.set,
                               {{"name", element(language_, names_.target, slot)},
                                {"value", printer.use(emission_.graph().results[slot])}}));
    if (!rest_.guards.empty()) text.statement(2, language_.functions.success);
    emission_.uses.add(inner.uses);
    return with_head(std::move(text));
  }

private:
  bool is_given(NodeId id) const { return emission_.plan.element(id).has_value(); }

  // The scalar operations, as a graph of the same nodes, in which vector lanes and array elements are inputs. Its
  // results are the scalars that vectors are built from, and those stored alone.
  Graph rest() {
    Graph rest = emission_.graph();
    rest.precomputed.clear();
    rest.results.clear();
    std::vector<char> const constant = hides_arguments(rest) ? constant_on_a_path(rest) : std::vector<char>{};
    for (NodeId id = 0; id < rest.nodes.size(); ++id) {
      lanes::Lane const &lane = function_.lane[id];
      if (!lane.is_given() && !is_given(id)) continue;
      std::string leaf;
      if (lane.is_given())
        leaf = vectors_.is_variable(lane.vector) ? vectors_.lane(lane) : "";
      else if (std::optional<Element> const place = emission_.plan.element(id))
        leaf = element(language_, name_of(place->array), place->index);
      rest.nodes[id] = Node::input(static_cast<std::uint32_t>(leaves_.size()));
      leaves_.push_back(std::move(leaf));
      constant_leaves_.push_back(!constant.empty() && constant[id] != 0);
    }
    auto const want = [&](NodeId id) {
      if (!is_leaf(rest.nodes[id].op)) rest.results.push_back(id);
    };
    for (Vector const &vector : function_.vectors)
      if (vector.form == Vector::Form::splat || vector.form == Vector::Form::build)
        std::ranges::for_each(vector.nodes, want);
    for (std::size_t slot = 0; slot < emission_.graph().results.size(); ++slot)
      if (function_.is_stored_alone(slot)) want(emission_.graph().results[slot]);
    return rest;
  }

  // Sorts the scalar statements into the order of the function, and determines the vectors before each.
  void put_in_order() {
    std::vector<std::uint32_t> turn(rest_.nodes.size(), 0);
    for (std::uint32_t k = 0; k < function_.order.size(); ++k)
      if (!function_.order[k].is_vector) turn[function_.order[k].id] = k;
    PlanFunction &body = plan_.compute();
    internal_check(std::ranges::all_of(body.region, [](RegionId region) { return region == everywhere; }));
    std::ranges::stable_sort(body.variables, {}, [&](NodeId id) { return turn[id]; });
    for (Check &check : body.checks) check.before = behind_all;
    before_.resize(body.variables.size() + 1);
    std::size_t statement = 0;
    for (std::uint32_t k = 0; k < function_.order.size(); ++k) {
      while (statement < body.variables.size() && turn[body.variables[statement]] < k) ++statement;
      if (function_.order[k].is_vector) before_[statement].push_back(function_.order[k].id);
    }
  }

  void print_vectors(std::size_t statement, BodyPrinter &printer, CodeText &out) const {
    for (VectorId id : before_[statement]) {
      if (!vectors_.is_variable(id)) continue;
      std::vector<NodeId> computed;
      std::string const value = vectors_.value(id, [&](NodeId node) { return printer.use(node); }, computed);
      out.statement(2,
                    fill(language_, language_.statements.constant,
                         {{"type", vectors_.type()}, {"name", vectors_.name(id)}, {"value", value}}),
                    origin_of(emission_, computed));
    }
  }

  CodeText with_head(CodeText text) const {
    FunctionSyntax const &syntax = language_.functions;
    std::set<Array> used;
    if (emission_.plan.angles.size() != 0) used.insert(Array::input);
    if (emission_.plan.angles.computed != 0) used.insert(Array::constants); // passed on by the call
    for (lanes::Item const &item : function_.order)
      if (item.is_vector) {
        Vector const &vector = function_.vectors[item.id];
        if (vector.form == Vector::Form::load) used.insert(vector.array);
        for (NodeId node : vector.nodes) note(node, used);
      } else {
        for (NodeId operand : emission_.graph().nodes[item.id].operand) note(operand, used);
      }
    for (NodeId result : emission_.graph().results) note(result, used);
    for (Guard const &guard : emission_.graph().guards) note(guard.condition, used);
    std::vector<Parameter> parameters;
    for (Array const array : {Array::input, Array::constants})
      parameters.push_back({syntax.input, std::string(name_of(array)), used.contains(array)});
    parameters.push_back({syntax.output, names_.target});
    CodeText out(language_), whole(language_);
    print_angles(emission_, whole);
    whole.append(std::move(text));
    append_function(language_, syntax.head,
                    {.name = names_.name, .target = names_.target, .may_fail = !rest_.guards.empty()}, parameters,
                    std::move(whole), out);
    return out;
  }
  void note(NodeId id, std::set<Array> &used) const {
    if (id == no_node) return;
    if (std::optional<Element> const element = emission_.plan.element(id)) used.insert(element->array);
  }

  Emission &emission_;
  Language const &language_;
  lanes::LaneFunction const &function_;
  FunctionNames const &names_;
  VectorText vectors_;
  std::vector<std::string> leaves_;
  std::vector<char> constant_leaves_;
  Graph rest_;
  Plan plan_;
  std::vector<std::vector<VectorId>> before_; // per statement, and after the last
};

} // namespace

CodeText print_lanes(Emission &emission, PlanFunction const &function, FunctionNames const &names) {
  return LanesPrinter(emission, function, names).print();
}

} // namespace symreal
