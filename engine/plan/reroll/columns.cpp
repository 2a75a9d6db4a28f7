#include "engine/plan/reroll/columns.h"

#include <bit>
#include <map>
#include <optional>

namespace symreal::reroll {

namespace {

class BodyOfRepeat {
public:
  BodyOfRepeat(Sequence const &sequence, Repeat const &repeat, std::vector<std::uint32_t> const &uses)
      : sequence_(sequence),
        repeat_(repeat),
        uses_(uses),
        body_{repeat, std::vector<BodyOperation>(repeat.period), {}} {}

  LoopBody run() {
    for (std::uint32_t p = 0; p < repeat_.period; ++p) {
      Operation const &first = operation(0, p);
      body_.operations[p] = {first.op, first.node, first.count, {}};
      for (unsigned i = 0; i < first.count; ++i) body_.operations[p].operands[i] = operand(p, i);
    }
    for (std::uint32_t p = 0; p < repeat_.period; ++p)
      for (unsigned i = 0; i < body_.operations[p].count; ++i) settle_sign(p, i);
    drop_unused_columns();
    return std::move(body_);
  }

private:
  Operation const &operation(std::uint32_t iteration, std::uint32_t p) {
    return sequence_.operations[repeat_.begin + iteration * repeat_.period + p];
  }
  Operand const &operand_at(std::uint32_t iteration, std::uint32_t p, unsigned i) {
    return operation(iteration, p).operands[i];
  }

  BodyOperand operand(std::uint32_t p, unsigned i) {
    if (std::optional<std::uint32_t> const inside = position_inside(p, i)) return {.position = *inside};
    Column column;
    for (std::uint32_t k = 0; k < repeat_.count; ++k) {
      NodeId const node = operand_at(k, p, i).node;
      if (sequence_.array(node) == Array::values)
        column.values.push_back(sequence_.graph->nodes[node].value());
      else
        column.nodes.push_back(node);
    }
    return {.column = number_of(std::move(column))};
  }

  // Body operation that computes the operand in every iteration; nullopt if it varies.
  std::optional<std::uint32_t> position_inside(std::uint32_t p, unsigned i) {
    std::uint32_t const first = sequence_.position[operand_at(0, p, i).node];
    if (first == no_position || first < repeat_.begin || first >= repeat_.begin + p) return {};
    for (std::uint32_t k = 1; k < repeat_.count; ++k)
      if (sequence_.position[operand_at(k, p, i).node] != first + k * repeat_.period) return {};
    return first - repeat_.begin;
  }

  std::uint32_t number_of(Column column) {
    std::vector<std::uint64_t> key(1, column.nodes.size());
    for (NodeId node : column.nodes) key.push_back(node);
    for (double value : column.values) key.push_back(std::bit_cast<std::uint64_t>(value));
    auto const [entry, is_new] = numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(body_.columns.size()));
    if (is_new) body_.columns.push_back(std::move(column));
    return entry->second;
  }

  // Moves a sign that varies between iterations into the constants of a product with this single use, or into a factor.
  void settle_sign(std::uint32_t p, unsigned i) {
    BodyOperand &operand = body_.operations[p].operands[i];
    std::vector<double> signs;
    bool is_mixed = false;
    for (std::uint32_t k = 0; k < repeat_.count; ++k) {
      signs.push_back(operand_at(k, p, i).negated ? -1 : 1);
      is_mixed = is_mixed || signs.back() != signs.front();
    }
    if (!is_mixed)
      operand.negated = signs.front() < 0;
    else if (BodyOperand *const factor = is_values(operand) ? &operand : factor_for(operand))
      factor->column = number_of(signed_values(body_.columns[factor->column].values, signs));
    else
      operand.sign = number_of({{}, signs});
  }

  bool is_values(BodyOperand const &operand) const {
    return operand.column != no_column && body_.columns[operand.column].nodes.empty();
  }

  // Constant factor of the product that only this operand uses; null if the operand is another operation.
  BodyOperand *factor_for(BodyOperand const &operand) {
    if (operand.position == no_position) return nullptr;
    BodyOperation &product = body_.operations[operand.position];
    if (product.op != Op::mul) return nullptr;
    for (std::uint32_t k = 0; k < repeat_.count; ++k)
      if (uses_[operation(k, operand.position).node] != 1) return nullptr;
    for (unsigned i = 0; i < 2; ++i)
      if (is_values(product.operands[i])) return &product.operands[i];
    return nullptr;
  }

  static Column signed_values(std::vector<double> values, std::vector<double> const &signs) {
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= signs[k];
    return {{}, std::move(values)};
  }

  void drop_unused_columns() {
    std::vector<std::uint32_t> now(body_.columns.size(), no_column);
    std::vector<Column> kept;
    auto const keep = [&](std::uint32_t &column) {
      if (column == no_column) return;
      if (now[column] == no_column) {
        now[column] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(std::move(body_.columns[column]));
      }
      column = now[column];
    };
    for (BodyOperation &operation : body_.operations)
      for (BodyOperand &operand : operation.operands) {
        keep(operand.column);
        keep(operand.sign);
      }
    body_.columns = std::move(kept);
  }

  Sequence const &sequence_;
  Repeat repeat_;
  std::vector<std::uint32_t> const &uses_;
  LoopBody body_;
  std::map<std::vector<std::uint64_t>, std::uint32_t> numbers_;
};

} // namespace

LoopBody loop_body(Sequence const &sequence, Repeat const &repeat, std::vector<std::uint32_t> const &uses) {
  return BodyOfRepeat(sequence, repeat, uses).run();
}

} // namespace symreal::reroll
