#include "algebra/constant_forms.h"

#include <algorithm>
#include <cmath>

namespace symreal::algebra {

ConstantForms::ConstantForms(std::span<double const> constants) {
  std::vector<double> distinct;
  for (double constant : constants)
    if (constant != 0 && std::isfinite(constant) && known_.emplace(constant, true).second) distinct.push_back(constant);
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    propose(FormKind::inverse, distinct[i], 0, 1 / distinct[i]);
    for (std::size_t j = i; j < std::min(distinct.size(), i + farthest); ++j) look(distinct[i], distinct[j]);
  }
}

void ConstantForms::look(double a, double b) {
  propose(FormKind::product, a, b, a * b);
  propose(FormKind::sum, a, b, a + b);
  propose(FormKind::difference, a, b, a - b);
}

// Whether `constant` is `other`, or comes from it.
bool ConstantForms::rests_on(double constant, double other, int depth) const {
  if (constant == other || depth == 0) return true;
  ConstantForm const *form = find(constant);
  if (!form) return false;
  return rests_on(form->a, other, depth - 1) || (form->b != 0 && rests_on(form->b, other, depth - 1));
}

void ConstantForms::propose(FormKind kind, double a, double b, double value) {
  value = std::fabs(value);
  if (!known_.contains(value) || forms_.contains(value)) return;
  // What is exact says nothing new, and small integers are sums of others everywhere.
  if (kind == FormKind::product && std::fma(a, b, -value) == 0) return;
  if (kind == FormKind::sum && (value - std::max(a, b)) == std::min(a, b)) return;
  if (kind == FormKind::difference && std::min(a, b) + value == std::max(a, b)) return;
  if (kind == FormKind::inverse && std::fma(a, value, -1.0) == 0) return;
  if (rests_on(a, value, deepest) || (b != 0 && rests_on(b, value, deepest))) return;
  forms_.emplace(value, ConstantForm{kind, a, b});
}

ConstantForm const *ConstantForms::find(double magnitude) const {
  auto const found = forms_.find(magnitude);
  return found == forms_.end() ? nullptr : &found->second;
}

} // namespace symreal::algebra
