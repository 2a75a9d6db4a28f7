#include "engine/emit/print/loop_indices.h"

#include <cmath>
#include <fmt/format.h>

namespace symreal {

namespace {

constexpr std::string_view all = "k", outer = "i", inner = "j";

} // namespace

std::string index_text(std::int64_t first, std::vector<std::pair<std::int64_t, std::string_view>> const &steps) {
  std::string added, subtracted;
  for (auto const &[step, index] : steps) {
    if (step == 0) continue;
    std::string const term = std::abs(step) == 1 ? std::string(index) : fmt::format("{}*{}", std::abs(step), index);
    if (step < 0)
      subtracted += " - " + term;
    else
      added += (added.empty() ? "" : " + ") + term;
  }
  if (added.empty()) return std::to_string(first) + subtracted;
  if (first == 0) return added + subtracted;
  return subtracted.empty() ? fmt::format("{} + {}", added, first) : fmt::format("{} + {}{}", first, added, subtracted);
}

LoopIndices::LoopIndices(Language const &language, reroll::LoopStep const &step)
    : language_(language),
      count_(step.count) {
  if (!is_loop()) return;
  nest_ = reroll::nest_of(step);
  for (std::string_view const name : {all, outer, inner})
    if (nest_ || name == all) names_.emplace(name);
}

std::optional<reroll::NestedAccess> LoopIndices::nested(reroll::Access const &access) const {
  return nest_ ? reroll::nested(access, *nest_) : std::nullopt;
}

std::string LoopIndices::of_iteration() {
  is_counted_ = true;
  return std::string(all);
}

std::string LoopIndices::of_turn() const { return std::string(outer); }

std::optional<std::string> LoopIndices::of_element(reroll::Access const &access) {
  if (std::optional<reroll::NestedAccess> const place = nested(access))
    return index_text(place->first, {{place->outer, outer}, {place->inner, inner}});
  if (access.is_listed()) return {};
  is_counted_ = is_counted_ || access.step != 0;
  return index_text(access.first, {{access.step, all}});
}

bool LoopIndices::is_fixed(reroll::Access const &access) const {
  return is_loop() && !access.is_listed() && access.step == 0;
}

bool LoopIndices::is_fixed_in_turn(reroll::Access const &access) const {
  std::optional<reroll::NestedAccess> const place = nested(access);
  return place && place->inner == 0;
}

std::size_t LoopIndices::begin(std::vector<std::string> const &of_turn, CodeText &out) const {
  std::size_t indent = 2;
  auto const begin_loop = [&](std::string_view index, std::string const &count) {
    out.statement(indent, fill(language_, language_.loops.begin, {{"index", index}, {"count", count}}));
    indent += 2;
  };
  if (nest_) {
    if (is_counted_) out.statement(indent, fill(language_, language_.loops.counter, {{"index", all}}));
    begin_loop(outer, std::to_string(nest_->turns));
    for (std::string const &statement : of_turn) out.statement(indent, statement);
    begin_loop(inner, index_text(nest_->inner, {{nest_->growth, outer}}));
  } else if (is_loop()) {
    begin_loop(all, std::to_string(count_));
  }
  return indent;
}

void LoopIndices::end(CodeText &out) const {
  if (nest_ && is_counted_) out.statement(6, fill(language_, language_.loops.count, {{"index", all}}));
  if (nest_) out.statement(4, language_.loops.end);
  if (is_loop()) out.statement(2, language_.loops.end);
}

bool Records::may_have(reroll::Access const &access) const {
  constexpr std::int64_t long_index = 1000;
  if (access.is_listed()) return false;
  return are_in_loop_ ? std::abs(access.step) > 1 : access.step == 0 && access.first >= long_index;
}

std::int64_t Records::span(std::int64_t step) const {
  constexpr std::int64_t most_elements = 64; // in straight-line code
  return are_in_loop_ ? std::abs(step) : most_elements;
}

void Records::add(std::string const &array, reroll::Access const &access, bool is_stored) {
  if (may_have(access)) firsts_[{array, access.step, is_stored}].insert(access.first);
}

void Records::choose() {
  auto const least_elements = are_in_loop_ ? 3 : 16;
  for (auto const &[key, firsts] : firsts_) {
    auto const &[array, step, is_stored] = key;
    for (auto begin = firsts.begin(); begin != firsts.end();) {
      auto const end = firsts.lower_bound(*begin + span(step));
      if (std::distance(begin, end) >= least_elements) chosen_.push_back({array, *begin, step, is_stored});
      begin = end;
    }
  }
}

std::optional<Records::Place> Records::find(std::string const &array, reroll::Access const &access,
                                            bool is_stored) const {
  if (!may_have(access)) return {};
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    Record const &record = chosen_[k];
    std::int64_t const element = access.first - record.first;
    bool const is_inside = element >= 0 && element < span(record.step);
    if (record.array == array && record.step == access.step && record.is_stored == is_stored && is_inside)
      return Place{k, element};
  }
  return {};
}

} // namespace symreal
