#include "engine/optimise/algebra/constant_forms.h"

#include <algorithm>
#include <cmath>

namespace symreal::algebra {

namespace {

// Number of successors that each constant is compared with; all if the budget `pairs` allows.
std::size_t reach(std::size_t least, std::size_t pairs, std::size_t count) {
  return std::max(least, pairs / std::max<std::size_t>(count, 1));
}

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

} // namespace symreal::algebra
