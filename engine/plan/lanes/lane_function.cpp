#include "engine/plan/lanes/search.h"

#include <algorithm>
#include <queue>

namespace symreal::lanes {

namespace {

class Program {
public:
  Program(ScalarFunction const &function, VectorChoice const &found)
      : function_(function),
        packs_(found.packs),
        needs_(function, packs_, found.stores),
        number_(packs_.size(), no_vector) {
    internal_check(needs_.cost() != Needs::impossible);
    result_.width = function.width();
    result_.lane.resize(function.graph().nodes.size());
    for (Item const &item : needs_.order())
      if (item.is_vector) add(item.id);
    for (Store const &store : found.stores) result_.stores.push_back({number_[store.vector], store.first});
  }

  LaneFunction run() {
    for (Item const &item : needs_.order())
      if (!item.is_vector) {
        alone_.push_back(item.id);
        ++result_.operations;
      }
    put_in_order();
    return std::move(result_);
  }

private:
  // Adds a vector whose operands have been added.
  void add(VectorId id) {
    Packs::Pack const &pack = packs_[id];
    Vector vector{.nodes = pack.nodes};
    if (pack.is_operation) {
      vector.form = Vector::Form::operation;
      vector.op = pack.op;
      vector.subtracts = pack.subtracts;
      for (std::size_t i = 0; i < 2; ++i)
        if (pack.operand[i] != no_vector) vector.operand[i] = number_[pack.operand[i]];
    } else {
      Source const source = packs_.source(id);
      vector.form = source.form;
      vector.from = source.from;
      if (source.form == Vector::Form::load) {
        number_[id] = load(source.parts[0], pack.nodes);
        return;
      }
      if (source.stride != 0) {
        number_[id] = column(source, pack.nodes);
        return;
      }
      for (std::size_t i = 0; i < source.parts.size(); ++i)
        vector.operand[i] = source.parts[i].is_load() ? load(source.parts[i], {}) : number_[source.parts[i].pack];
    }
    number_[id] = static_cast<VectorId>(result_.vectors.size());
    if (pack.is_operation)
      for (std::uint32_t lane = 0; lane < pack.nodes.size(); ++lane) {
        Lane &place = result_.lane[pack.nodes[lane]];
        if (packs_.place(pack.nodes[lane]).vector == id && !place.is_given()) {
          place = {number_[id], lane};
          ++result_.in_lanes;
          ++result_.operations;
        }
      }
    result_.vectors.push_back(std::move(vector));
  }

  // Loads a window of an array, once.
  VectorId load(Source::Window const &part, std::vector<NodeId> nodes) {
    auto const is_it = [&](Vector const &vector) {
      return vector.form == Vector::Form::load && vector.array == part.array && vector.first == part.first;
    };
    auto const at = std::ranges::find_if(result_.vectors, is_it);
    if (nodes.empty()) nodes.assign(function_.width(), no_node);
    if (at != result_.vectors.end()) {
      if (at->nodes[0] == no_node) at->nodes = std::move(nodes);
    } else {
      result_.vectors.push_back(
          {.form = Vector::Form::load, .nodes = std::move(nodes), .array = part.array, .first = part.first});
      return static_cast<VectorId>(result_.vectors.size() - 1);
    }
    return static_cast<VectorId>(at - result_.vectors.begin());
  }

  // A column of the matrix whose rows are windows of an array. Transposition in log2(width) steps: each joins
  // neighbours into vectors with blocks of twice as many rows and half as many columns.
  VectorId column(Source const &source, std::vector<NodeId> const &nodes) {
    std::size_t const width = function_.width();
    std::vector<VectorId> rows;
    for (std::size_t row = 0; row < width; ++row)
      rows.push_back(load({.array = source.parts[0].array, .first = source.parts[0].first + row * source.stride}, {}));
    for (std::size_t half = 1; half < width; half *= 2) {
      std::vector<std::uint32_t> from;
      for (std::size_t lane = 0; lane < width; ++lane) {
        std::size_t const block = lane / (2 * half) * (2 * half), inside = lane % (2 * half);
        from.push_back(
            static_cast<std::uint32_t>((inside < half ? 0 : width) + block + (source.column & half) + inside % half));
      }
      std::vector<VectorId> joined;
      for (std::size_t row = 0; row < rows.size(); row += 2) joined.push_back(shuffle(rows[row], rows[row + 1], from));
      rows = std::move(joined);
    }
    result_.vectors[rows[0]].nodes = nodes;
    return rows[0];
  }
  VectorId shuffle(VectorId x, VectorId y, std::vector<std::uint32_t> const &from) {
    Vector const wanted{.form = Vector::Form::shuffle,
                        .nodes = std::vector<NodeId>(function_.width(), no_node),
                        .operand = {x, y},
                        .from = from};
    auto const at = std::ranges::find_if(result_.vectors, [&](Vector const &vector) {
      return vector.form == wanted.form && vector.operand == wanted.operand && vector.from == from;
    });
    if (at != result_.vectors.end()) return static_cast<VectorId>(at - result_.vectors.begin());
    result_.vectors.push_back(wanted);
    return static_cast<VectorId>(result_.vectors.size() - 1);
  }

  // Calls `visit` with the operands of an item: node ids, or vector ids offset by the node count.
  template <class Visit> void for_each_need(std::uint32_t item, Visit const &visit) const {
    auto const need = [&](NodeId id) {
      if (!function_.is_computed(id)) return;
      Lane const &lane = result_.lane[id];
      visit(lane.is_given() ? key(lane.vector) : id);
    };
    if (item < key(0)) {
      for (NodeId operand : function_.node(item).operand)
        if (operand != no_node) need(operand);
      return;
    }
    Vector const &vector = result_.vectors[item - key(0)];
    for (VectorId operand : vector.operand)
      if (operand != no_vector) visit(key(operand));
    if (vector.form == Vector::Form::splat) need(vector.nodes[0]);
    if (vector.form == Vector::Form::build) std::ranges::for_each(vector.nodes, need);
  }
  std::uint32_t key(VectorId id) const { return static_cast<std::uint32_t>(function_.graph().nodes.size()) + id; }

  // Keeps the order of recording: a vector operation takes the place of its last lane, and its gathers come just before
  // it.
  void put_in_order() {
    std::size_t const count = key(0) + result_.vectors.size();
    std::vector<std::uint32_t> items = alone_;
    for (VectorId id = 0; id < result_.vectors.size(); ++id) items.push_back(key(id));
    std::vector<std::uint32_t> turn(count, 0), waits(count, 0);
    std::vector<std::vector<std::uint32_t>> users(count);
    for (std::uint32_t item : items)
      for_each_need(item, [&](std::uint32_t need) {
        users[need].push_back(item);
        ++waits[item];
      });
    for (NodeId id : alone_) turn[id] = id;
    std::vector<std::uint32_t> gathered;
    for (VectorId id = 0; id < result_.vectors.size(); ++id)
      if (result_.vectors[id].form == Vector::Form::operation)
        turn[key(id)] = std::ranges::max(result_.vectors[id].nodes);
      else
        gathered.push_back(key(id));
    for (std::size_t k = gathered.size(); k-- > 0;) { // users have higher ids
      turn[gathered[k]] = key(0);
      for (std::uint32_t user : users[gathered[k]]) turn[gathered[k]] = std::min(turn[gathered[k]], turn[user]);
    }
    using Turn = std::pair<std::uint32_t, std::uint32_t>;
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> ready;
    for (std::uint32_t item : items)
      if (waits[item] == 0) ready.push({turn[item], item});
    while (!ready.empty()) {
      std::uint32_t const item = ready.top().second;
      ready.pop();
      result_.order.push_back(item < key(0) ? Item{false, item} : Item{true, item - key(0)});
      for (std::uint32_t user : users[item])
        if (--waits[user] == 0) ready.push({turn[user], user});
    }
    internal_check(result_.order.size() == items.size());
  }

  ScalarFunction const &function_;
  Packs const &packs_;
  Needs needs_;
  std::vector<VectorId> number_; // per pack: its vector in the function
  std::vector<NodeId> alone_;
  LaneFunction result_;
};

} // namespace

LaneFunction lane_function(ScalarFunction const &function, VectorChoice const &found) {
  return Program(function, found).run();
}

} // namespace symreal::lanes
