#include "engine/optimise/algebra/graph_network.h"

#include "engine/graph/node_table.h"

namespace symreal::algebra {

namespace {

// Number of successors that each constant is compared with; all if the budget `pairs` allows.
std::size_t reach(std::size_t least, std::size_t pairs, std::size_t count) {
  return std::max(least, pairs / std::max<std::size_t>(count, 1));
}

// Maps nodes of a graph to literals of a network.
class Import {
public:
  Import(Graph const &graph, Network &network) : graph_(graph), network_(network), now_(graph.nodes.size()) {}

  Literal operator[](NodeId id) const { return now_[id]; }

  void run() {
    std::vector<char> const live = symreal::live_nodes(graph_);
    std::vector<double> constants;
    for (NodeId id = 0; id < graph_.nodes.size(); ++id)
      if (graph_.nodes[id].is_constant()) constants.push_back(std::fabs(graph_.nodes[id].value()));
    forms_.emplace(constants);
    for (NodeId id = 0; id < graph_.nodes.size(); ++id) now_[id] = make(id);
    for_each_root(graph_, [&](NodeId root) { network_.roots.push_back(now_[root]); });
  }

private:
  Literal make(NodeId id) {
    Node const &node = graph_.nodes[id];
    if (is_leaf(node.op)) return leaf(id);
    auto operand = [&](std::size_t i) { return now_[node.operand[i]]; };
    if (node.op == Op::neg) return -operand(0);
    bool const is_exact = !graph_.node_exact.empty() && graph_.node_exact[id];
    if (!is_exact) {
      switch (node.op) {
      case Op::add: return network_.sum(operand(0), operand(1));
      case Op::sub: return network_.sum(operand(0), -operand(1));
      case Op::mul: return network_.product(operand(0), operand(1));
      case Op::div:
        if (operand(1) == network_.zero()) break;
        return network_.quotient(operand(0), operand(1));
      default: break;
      }
    }
    OpaqueFunction function{node.op, arity(node.op), {}};
    bool const is_known = node.op == Op::sin || node.op == Op::cos;
    if (info(node.op).has(flag::EFFECT) || (is_exact && is_known)) function.origin = id + 1;
    for (std::size_t i = 0; i < function.arity; ++i) {
      NodeId const from = node.operand[i];
      function.operands[i] = graph_.nodes[from].is_constant() ? exact(from) : operand(i);
    }
    return network_.function(function);
  }

  Literal leaf(NodeId id) {
    Node const &node = graph_.nodes[id];
    if (node.op == Op::input) {
      HazardSet const itself = network_.hazards().of_input(node.slot());
      return network_.leaf(id, node.attribute, itself, random_value(node.slot()));
    }
    if (node.op == Op::parameter) return network_.leaf(id, node.attribute, no_hazard, random_parameter(node.slot()));
    double const value = node.value();
    if (value == 0) return network_.zero();
    return std::isfinite(value) ? number(value) : exact(id);
  }

  // A constant in terms of its form.
  Literal number(double signed_value) {
    double const value = std::fabs(signed_value);
    bool const negative = signed_value < 0;
    ConstantForm const *form = forms_->find(value);
    if (!form) return network_.constant(signed_value);
    Literal const a = number(form->a), b = number(form->b);
    Literal made;
    switch (form->kind) {
    case FormKind::sum: made = network_.sum(a, b); break;
    case FormKind::product: made = network_.product(a, b); break;
    case FormKind::quotient: made = network_.quotient(a, b); break;
    case FormKind::sum_with_product: made = network_.sum(a, network_.product(b, number(form->c))); break;
    }
    bool const made_negative = network_.value(made).number[0] < 0;
    return made.negated_if(negative != made_negative);
  }

  // A constant without its form, for operations that are opaque to algebra.
  Literal exact(NodeId id) {
    double const value = graph_.nodes[id].value();
    if (std::isfinite(value) && (value != 0 || !std::signbit(value))) return network_.constant(value);
    std::uint64_t const key = mixed(std::bit_cast<std::uint64_t>(value));
    return network_.leaf(id, Attribute::parametric, no_hazard, random_parameter(key));
  }

  Graph const &graph_;
  Network &network_;
  std::optional<ConstantForms> forms_;
  std::vector<Literal> now_;
};

class Export {
public:
  Export(Network const &network, Graph const &graph) : network_(network), graph_(graph), now_(network.size()) {}

  bool run() {
    std::vector<char> const live = live_nodes(network_);
    for (Index node = 0; node < network_.size(); ++node)
      if (live[node] && !make(node)) return false;
    return true;
  }

  NodeId node_of(Literal literal) {
    NodeId const id = now_[literal.node()];
    if (!literal.is_negative()) return id;
    if (table_[id].is_constant()) return table_.constant(-table_[id].value());
    return table_.intern(table_.operation(Op::neg, id));
  }
  NodeTable &table() { return table_; }
  std::vector<NodeId> const &nodes() const { return now_; }
  // Arithmetic operations that were imported as exact.
  std::vector<NodeId> const &exact() const { return exact_; }

private:
  static bool is_arithmetic(Op op) { return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div; }

  bool make(Index index) {
    NetworkNode const &node = network_[index];
    NodeId &id = now_[index];
    if (node.kind == Kind::function) {
      OpaqueFunction const &function = network_.function_of(node);
      std::array<NodeId, 3> operands = {no_node, no_node, no_node};
      for (std::size_t i = 0; i < function.arity; ++i) operands[i] = node_of(function.operands[i]);
      id = table_.intern(table_.operation(function.op, operands[0], operands[1], operands[2]));
      if (is_arithmetic(function.op)) exact_.push_back(id);
    } else if (node.kind == Kind::leaf) {
      id = table_.intern(graph_.nodes[node.a.bits]);
    } else if (node.attribute == Attribute::constant) {
      auto const value = static_cast<double>(node.value.number[0]);
      id = table_.constant(value);
      return value == 0 ? node.value.is_zero() : std::isnormal(value) || node.kind == Kind::constant;
    } else if (node.kind == Kind::sum) {
      NodeId const b = now_[node.b.node()];
      bool const minus = node.b.is_negative();
      if (table_[now_[node.a.node()]].is_constant() && !minus) // constants are second operands
        id = table_.intern(table_.operation(Op::add, b, now_[node.a.node()]));
      else
        id = table_.intern(table_.operation(minus ? Op::sub : Op::add, now_[node.a.node()], b));
    } else {
      Op const op = node.kind == Kind::product ? Op::mul : Op::div;
      NodeId const a = now_[node.a.node()], b = now_[node.b.node()];
      bool const exchanged = op == Op::mul && table_[a].is_constant();
      id = table_.intern(table_.operation(op, exchanged ? b : a, exchanged ? a : b));
    }
    return true;
  }

  Network const &network_;
  Graph const &graph_;
  NodeTable table_;
  std::vector<NodeId> now_, exact_;
};

} // namespace

ConstantForms::ConstantForms(std::span<double const> constants) {
  for (double constant : constants) {
    if (constant == 0 || !std::isfinite(constant)) continue;
    std::uint32_t &place = place_[std::bit_cast<std::uint64_t>(constant)];
    if (place != KeyTable::none) continue;
    place = static_cast<std::uint32_t>(constants_.size());
    constants_.push_back(constant);
  }
  forms_.resize(constants_.size());
  for (bool only_earlier : {true, false}) {
    only_earlier_ = only_earlier;
    look_at_pairs();
    look_at_products();
  }
}

void ConstantForms::look_at_pairs() {
  std::size_t const farthest = reach(600, 3'000'000, constants_.size());
  for (std::size_t i = 0; i < constants_.size(); ++i) {
    double const a = constants_[i];
    propose(1 / a, {FormKind::quotient, 1, a});
    for (std::size_t j = i; j < std::min(constants_.size(), i + farthest); ++j) {
      double const b = constants_[j];
      propose(a * b, {FormKind::product, a, b});
      propose(a + b, {FormKind::sum, a, b});
      propose(a - b, {FormKind::sum, a, -b});
      propose(a / b, {FormKind::quotient, a, b});
      propose(b / a, {FormKind::quotient, b, a});
    }
  }
}

// Searches block by block: for each pair of constants, products that make up their difference.
void ConstantForms::look_at_products() {
  std::size_t const length = reach(150, 1'000'000, constants_.size());
  for (std::size_t first = 0, end = 0; end < constants_.size(); first += length / 2) {
    end = std::min(first + length, constants_.size());
    std::span<double const> const block(&constants_[first], end - first);
    std::vector<Product> products;
    for (std::size_t i = 0; i < block.size(); ++i)
      for (std::size_t j = i; j < block.size(); ++j) products.push_back({block[i] * block[j], block[i], block[j]});
    std::ranges::sort(products, {}, &Product::value);
    for (std::size_t at = first; at < end; ++at) {
      if (forms_[at]) continue;
      double const value = constants_[at];
      for (double a : block)
        for (double wanted : {value - a, value + a}) { // a + b * c, b * c - a or a - b * c
          double const slack = 0x1p-52 * std::max(value, a), size = std::fabs(wanted);
          for (auto product = std::ranges::lower_bound(products, size - slack, {}, &Product::value);
               product != products.end() && product->value <= size + slack; ++product)
            for (double sign : {1.0, -1.0})
              propose(a + sign * product->value, {FormKind::sum_with_product, a, sign * product->a, product->b});
        }
    }
  }
}

// Whether `constant` is `other` or derived from it, to this depth.
bool ConstantForms::rests_on(double constant, double other, int depth) const {
  constant = std::fabs(constant);
  if (constant == 0) return false;
  if (constant == other || depth == 0) return true;
  ConstantForm const *form = find(constant);
  return form && (rests_on(form->a, other, depth - 1) || rests_on(form->b, other, depth - 1) ||
                  rests_on(form->c, other, depth - 1));
}

void ConstantForms::propose(double value, ConstantForm const &form) {
  value = std::fabs(value);
  std::uint32_t const place = place_of(value);
  if (place == KeyTable::none || forms_[place]) return;
  auto is_later = [&](double operand) {
    std::uint32_t const other = place_of(std::fabs(operand));
    return other != KeyTable::none && other >= place;
  };
  if (only_earlier_ && (is_later(form.a) || is_later(form.b) || is_later(form.c))) return;
  // Constants of few bits are sums and products of others by chance, unless rounding left them of a difference.
  double const shifted = std::ldexp(value, 20 - std::ilogb(value));
  if (shifted == std::floor(shifted) && value > 0x1p-50 * std::fabs(form.a)) return;
  if (rests_on(form.a, value, deepest) || rests_on(form.b, value, deepest) || rests_on(form.c, value, deepest)) return;
  forms_[place] = form;
}

ConstantForm const *ConstantForms::find(double magnitude) const {
  std::uint32_t const place = place_of(magnitude);
  return place == KeyTable::none || !forms_[place] ? nullptr : &*forms_[place];
}

Network network_of(Graph const &graph, CostModel const &costs) {
  Network network(std::make_shared<Context>(costs));
  Import(graph, network).run();
  return network;
}

std::optional<Graph> graph_of(Network const &network, Graph const &graph) {
  Export made(network, graph);
  if (!made.run()) return std::nullopt;
  // Names, locations and exactness of the old nodes carry over to the new nodes of equal value.
  Network values(network.context());
  Import old(graph, values);
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  if (!graph.node_location.empty() || !graph.node_name.empty() || !graph.node_exact.empty()) {
    old.run();
    std::vector<char> const live = live_nodes(network), was_live = symreal::live_nodes(graph);
    for (NodeId id = 0; id < now.size(); ++id) {
      if (!was_live[id] || is_leaf(graph.nodes[id].op)) continue;
      std::optional<Literal> const found = network.find(values.value(old[id]));
      if (!found || found->is_negative() || !live[found->node()]) continue;
      NodeId const node = made.nodes()[found->node()];
      if (!is_leaf(made.table()[node].op)) now[id] = node;
    }
  }
  std::size_t next = 0;
  for_each_root(graph, [&](NodeId root) { now[root] = made.node_of(network.roots[next++]); });
  Graph result = without_nodes(graph);
  result.nodes = made.table().release();
  if (!graph.node_exact.empty()) {
    result.node_exact.resize(result.nodes.size(), 0);
    for (NodeId id : made.exact()) result.node_exact[id] = 1;
  }
  carry_over(graph, now, result);
  return result;
}

} // namespace symreal::algebra
