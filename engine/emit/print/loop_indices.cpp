#include "engine/emit/print/loop_indices.h"

#include "engine/emit/language/pattern.h"

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

LoopIndices::LoopIndices(Language const &language, reroll::Step const &step) : language_(language), count_(step.count) {
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

} // namespace symreal
