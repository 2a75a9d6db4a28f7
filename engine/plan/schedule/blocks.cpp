#include "engine/plan/schedule/blocks.h"

#include "engine/plan/schedule/dependences.h"

#include <algorithm>

namespace symreal {

namespace {

constexpr std::size_t never = ~std::size_t{0};

class Blocks {
public:
  Blocks(Plan const &plan, PlanFunction const &body, Chunks const &chunks, std::size_t chunk)
      : plan_(plan),
        body_(body),
        chunks_(chunks),
        chunk_(chunk),
        first_(chunks.begin[chunk]),
        variables_(chunks.begin[chunk + 1] - first_) {}

  std::vector<BlockStep> run() {
    std::vector<std::size_t> const last_stores = place_stores();
    auto check = std::partition_point(body_.checks.begin(), body_.checks.end(),
                                      [&](Check const &one) { return chunks_.of_check(one) < chunk_; });
    for (std::size_t k = first_; k <= first_ + variables_.size(); ++k) {
      for (; check != body_.checks.end() && check->before == k && chunks_.of_check(*check) == chunk_; ++check) {
        move_to({});
        steps_.push_back({BlockStep::Kind::check, static_cast<std::size_t>(check - body_.checks.begin())});
        note_read(check->condition);
      }
      if (k == first_ + variables_.size()) break;
      move_to(body_.regions.literals(body_.region[k]));
      for_each_operand(plan_, body_, body_.variables[k], [&](NodeId id) { note_read(id); });
      variables_[k - first_].block = open_.empty() ? never : open_.back().id;
      steps_.push_back({BlockStep::Kind::set, k});
    }
    move_to({});
    for (std::size_t const result : last_stores) note_read(body_.results[result]);
    std::vector<BlockStep> steps = with_declarations();
    Stores const &stores = chunks_.stores;
    for (std::size_t k = 0; chunk_ == stores.first_chunk && k < stores.copied.size(); ++k)
      steps.push_back({BlockStep::Kind::copy, k});
    for (std::size_t const result : last_stores) steps.push_back({BlockStep::Kind::store, result});
    return steps;
  }

private:
  struct Open {
    Literal literal;
    std::size_t id;
    bool is_else = false;
  };
  struct Variable {
    std::size_t block = never; // block that sets it; `never`: it is outside all blocks
    bool read_outside = false;
    std::vector<std::size_t> results = {}; // stored as soon as it is set
  };

  // Assigns the results of this chunk to their variables; returns those stored at its end.
  std::vector<std::size_t> place_stores() {
    std::vector<std::size_t> last;
    for (std::size_t const result : chunks_.stores.of_chunk[chunk_]) {
      std::size_t setter = never;
      if (chunk_ != chunks_.stores.first_chunk)
        for_each_variable(body_.results[result], [&](NodeId id) {
          if (is_own(id)) setter = chunks_.statement[id] - first_;
        });
      (setter == never ? last : variables_[setter].results).push_back(result);
    }
    return last;
  }

  // Closes and opens blocks so that exactly these literals hold.
  void move_to(std::vector<Literal> wanted) {
    std::size_t kept = 0;
    auto is_wanted = [&](Literal const &literal) {
      return std::find(wanted.begin(), wanted.end(), literal) != wanted.end();
    };
    while (kept < open_.size() && is_wanted(open_[kept].literal)) ++kept;
    for (std::size_t i = 0; i < kept; ++i) std::erase(wanted, open_[i].literal);
    while (open_.size() > kept + 1) close();
    if (open_.size() > kept) {
      Literal const opposite{open_.back().literal.condition, !open_.back().literal.holds};
      if (is_wanted(opposite) && !open_.back().is_else) { // an if has a single else: another c needs a new if
        std::erase(wanted, opposite);
        ends_[open_.back().id] = steps_.size();
        steps_.push_back({BlockStep::Kind::otherwise, 0, opposite});
        open_.back() = {opposite, ends_.size(), true};
        ends_.push_back(never);
      } else {
        close();
      }
    }
    for (Literal const &literal : wanted) {
      note_read(literal.condition);
      steps_.push_back({BlockStep::Kind::open, 0, literal});
      open_.push_back({literal, ends_.size()});
      ends_.push_back(never);
    }
  }

  void close() {
    ends_[open_.back().id] = steps_.size();
    steps_.push_back({BlockStep::Kind::close});
    open_.pop_back();
  }

  void note_read(NodeId use) {
    for_each_variable(use, [&](NodeId id) {
      if (!is_own(id)) return;
      Variable &variable = variables_[chunks_.statement[id] - first_];
      if (variable.block != never && ends_[variable.block] != never) variable.read_outside = true;
    });
  }

  template <class Visit> void for_each_variable(NodeId use, Visit const &visit) const {
    for_each_read(
        *plan_.graph, use, [&](NodeId id) { return is_variable(id); },
        [&](NodeId id) { return is_read(plan_, body_.kind, id); }, visit);
  }

  bool is_own(NodeId id) const {
    return chunks_.statement[id] >= first_ && chunks_.statement[id] < first_ + variables_.size();
  }
  // Whether the node is a variable of this chunk, or spilled by an earlier one.
  bool is_variable(NodeId id) const { return is_own(id) || chunks_.spill_slot[id] != no_slot; }

  bool is_kept(std::size_t statement) const { return chunks_.spill_slot[body_.variables[statement]] != no_slot; }

  // Adds declarations; spilled variables are declared before, and stored behind, the outermost block.
  std::vector<BlockStep> with_declarations() {
    std::vector<BlockStep> result;
    for (std::size_t at = 0; at < steps_.size();) {
      std::size_t const end = group_end(at);
      std::vector<BlockStep> behind;
      for (std::size_t i = at; i < end; ++i) {
        if (steps_[i].kind != BlockStep::Kind::set) continue;
        Variable &variable = variables_[steps_[i].index - first_];
        if (variable.block == never) continue;
        std::size_t const count = behind.size();
        push_stores(steps_[i].index, behind);
        variable.read_outside |= behind.size() != count;
        if (variable.read_outside) result.push_back({BlockStep::Kind::declare, steps_[i].index});
      }
      for (std::size_t i = at; i < end; ++i) {
        result.push_back(steps_[i]);
        if (steps_[i].kind != BlockStep::Kind::set) continue;
        Variable const &variable = variables_[steps_[i].index - first_];
        if (!variable.read_outside) result.back().kind = BlockStep::Kind::set_const;
        if (variable.block == never) push_stores(steps_[i].index, result);
      }
      result.insert(result.end(), behind.begin(), behind.end());
      at = end;
    }
    return result;
  }

  // Adds the steps that store the value of a statement.
  void push_stores(std::size_t statement, std::vector<BlockStep> &steps) const {
    if (is_kept(statement)) steps.push_back({BlockStep::Kind::keep, statement});
    for (std::size_t const result : variables_[statement - first_].results)
      steps.push_back({BlockStep::Kind::store, result});
  }

  // End of the group at `at`: one step outside all blocks, or one outermost block.
  std::size_t group_end(std::size_t at) const {
    std::size_t depth = 0;
    do {
      if (steps_[at].kind == BlockStep::Kind::open) ++depth;
      if (steps_[at].kind == BlockStep::Kind::close) --depth;
      ++at;
    } while (depth != 0);
    return at;
  }

  Plan const &plan_;
  PlanFunction const &body_;
  Chunks const &chunks_;
  std::size_t chunk_, first_;
  std::vector<Variable> variables_; // of this chunk, in order
  std::vector<BlockStep> steps_;
  std::vector<Open> open_;
  std::vector<std::size_t> ends_; // per block: the step that ends it, or never
};

} // namespace

std::vector<BlockStep> blocks(Plan const &plan, PlanFunction const &body, Chunks const &chunks, std::size_t chunk) {
  return Blocks(plan, body, chunks, chunk).run();
}

} // namespace symreal
