#include "engine/emit/print/lanes.h"

#include "engine/emit/origins/origins.h"
#include "engine/emit/print/angles.h"
#include "engine/emit/print/body.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/function_head.h"
#include "engine/emit/print/vector_text.h"

#include <algorithm>

namespace symreal {

namespace {

constexpr std::size_t behind_all = ~std::size_t{0};

class LanesPrinter {
public:
  LanesPrinter(Emission &emission, lanes::LaneFunction const &function)
      : emission_(emission),
        language_(emission.language),
        function_(function),
        vectors_(emission, function),
        rest_(rest()),
        plan_(schedule(rest_)) {
    put_in_order();
  }

  CodeText print() {
    Language whole = language_; // the body is not cut
    whole.functions.most_statements = std::string::npos;
    Emission inner{plan_, whole, emission_.options, nullptr, nullptr, vectors_.names()};
    BodyPrinter printer(inner, plan_.compute, true, "output");
    printer.spell_inputs(leaves_, constant_leaves_);
    CodeText text(language_);
    printer.set_before([&](std::size_t statement, CodeText &out) { print_vectors(statement, printer, out); });
    printer.statements(0, text);
    print_vectors(plan_.compute.variables.size(), printer, text);
    printer.checks(text);
    for (lanes::Store const &store : function_.stores) text.statement(2, vectors_.store(store, "output"));
    for (std::size_t slot = 0; slot < emission_.graph().results.size(); ++slot)
      if (function_.is_stored_alone(slot))
        text.statement(2, fill(language_, language_.statements.set,
                               {{"name", element(language_, "output", slot)},
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
    for (lanes::Vector const &vector : function_.vectors)
      if (vector.form == lanes::Vector::Form::splat || vector.form == lanes::Vector::Form::build)
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
    FunctionBody &body = plan_.compute;
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
    for (lanes::VectorId id : before_[statement]) {
      if (!vectors_.is_variable(id)) continue;
      std::vector<NodeId> computed;
      std::string const value = vectors_.value(id, [&](NodeId node) { return printer.use(node); }, computed);
      out.statement(2,
                    fill(language_, language_.statements.constant,
                         {{"type", vectors_.type()}, {"name", vectors_.name(id)}, {"value", value}}),
                    origin(computed));
    }
  }

  Origin origin(std::vector<NodeId> const &computed) const {
    Origin origin{locations_of(emission_.graph(), computed), {}};
    if (emission_.options.trace_comments && !origin.locations.empty())
      origin.comment = describe_locations(emission_.graph(), origin.locations);
    return origin;
  }

  // Marks parameters that the text does not use, against compiler warnings.
  CodeText with_head(CodeText text) const {
    FunctionSyntax const &syntax = language_.functions;
    std::set<Array> used;
    if (emission_.plan.angles.size() != 0) used.insert(Array::input);
    if (!emission_.plan.angles.computed.results.empty()) used.insert(Array::constants); // passed on by the call
    for (lanes::Item const &item : function_.order)
      if (item.is_vector) {
        lanes::Vector const &vector = function_.vectors[item.id];
        if (vector.form == lanes::Vector::Form::load) used.insert(vector.array);
        for (NodeId node : vector.nodes) note(node, used);
      } else {
        for (NodeId operand : emission_.graph().nodes[item.id].operand) note(operand, used);
      }
    for (NodeId result : emission_.graph().results) note(result, used);
    for (Guard const &guard : emission_.graph().guards) note(guard.condition, used);
    std::string parameters;
    CodeText out(language_), marks(language_);
    for (Array const array : {Array::input, Array::constants}) {
      parameters += fill(language_, syntax.input, {{"name", name_of(array)}}) + ", ";
      if (!used.contains(array)) marks.statement(2, fill(language_, syntax.unused, {{"name", name_of(array)}}));
    }
    parameters += fill(language_, syntax.output, {{"name", "output"}});
    out.statement(0, print_head(language_, syntax.head,
                                {.name = emission_.name("compute"),
                                 .parameters = parameters,
                                 .target = "output",
                                 .may_fail = !rest_.guards.empty()}));
    out.append(std::move(marks));
    print_angles(emission_, out);
    out.append(std::move(text));
    out.statement(0, syntax.end);
    return out;
  }
  void note(NodeId id, std::set<Array> &used) const {
    if (id == no_node) return;
    if (std::optional<Element> const element = emission_.plan.element(id)) used.insert(element->array);
  }

  Emission &emission_;
  Language const &language_;
  lanes::LaneFunction const &function_;
  VectorText vectors_;
  std::vector<std::string> leaves_;
  std::vector<char> constant_leaves_;
  Graph rest_;
  Schedule plan_;
  std::vector<std::vector<lanes::VectorId>> before_; // per statement, and after the last
};

} // namespace

CodeText print_lanes(Emission &emission, lanes::LaneFunction const &function) {
  return LanesPrinter(emission, function).print();
}

} // namespace symreal
