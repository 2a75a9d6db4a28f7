#include "program/derivative_verification.h"

#include "differentiate/differentiate.h"
#include "graph/evaluate.h"
#include "graph/extended.h"
#include "verify/compare.h"

#include <algorithm>
#include <cmath>

namespace symreal::program {

namespace {

constexpr std::size_t most_samples = 200;
constexpr double most_operations = 4e7; // in extended precision: a few seconds
constexpr double most_rounding = 64;    // times as much as the derivative loses before any pass

std::string obstacle(Differences const &differences, Graph const &graph, Banner const &banner) {
  if (banner.is_single) return "the code is in single precision";
  if (calls_program(graph)) return "the kernel calls functions of the program";
  return differences.obstacle();
}

} // namespace

DerivativeVerification::DerivativeVerification(Graph const &recorded, std::string const &path, Banner const &banner,
                                               double tolerance)
    : differences_(recorded, banner.derivatives),
      differentiated_(differentiate(recorded, banner.derivatives, [](Diagnostic const &) {})),
      mode_(banner.mode) {
  if (std::string const why = obstacle(differences_, recorded, banner); !why.empty())
    fail(DiagnosticId::derivative_unverified, {path, 1, 1}, "the derivatives cannot be checked: " + why);
  result_.tolerance = tolerance;
  result_.elements.resize(differences_.output_count());
  result_.objects.assign(differentiated_.outputs.begin() + static_cast<std::ptrdiff_t>(recorded.outputs.size()),
                         differentiated_.outputs.end());
  for (std::size_t k = 0; k < differences_.seed_count(); ++k) // between -1 and 1, no two alike
    seeds_.push_back(std::remainder(0.3 + 0.6180339887498949 * static_cast<double>(k), 1.0) * 2);
  double const each = static_cast<double>(recorded.nodes.size() * differences_.evaluations());
  most_ = std::clamp(static_cast<std::size_t>(most_operations / std::max(each, 1.0)), least_judged * 2, most_samples);
}

std::vector<double> DerivativeVerification::with_seeds(std::vector<double> inputs) const {
  inputs.insert(inputs.end(), seeds_.begin(), seeds_.end());
  return inputs;
}

// As of any kernel, but that the reference is the graph with its derivatives. `values`: of its nodes.
void DerivativeVerification::compare_with_formulas(Sample const &sample, std::span<double const> values,
                                                   std::span<double const> found) {
  if (mode_ == FloatingPoint::fast) return;
  if (!check_premises(differentiated_, values).hold_in(mode_)) return;
  ++result_.promised;
  std::size_t const first = differentiated_.results.size() - found.size();
  for (std::size_t k = 0; k < found.size(); ++k) {
    double const promised = values[differentiated_.results[first + k]];
    if (same(promised, found[k], mode_, 0)) continue;
    DerivativeElement &element = result_.elements[k];
    if (element.broken++ == 0) element.promised = promised, element.given = found[k], element.first_broken = sample;
  }
}

void DerivativeVerification::compare(Sample const &sample, std::span<double const> found) {
  if (result_.tried == most_) return;
  std::vector<double> const inputs = with_seeds(sample.inputs);
  std::vector<double> const values = evaluate(differentiated_, inputs, sample.parameters);
  auto const exact = evaluate_extended(differentiated_, std::span<double const>(inputs), sample.parameters, values);
  if (!exact) return; // at a decision
  ++result_.tried;
  compare_with_formulas(sample, values, found);
  std::vector<SharpNumber> const expected = differences_.at(inputs, sample.parameters, result_.tolerance);
  std::size_t const first = exact->size() - expected.size();
  for (std::size_t k = 0; k < expected.size(); ++k) {
    SharpNumber const &sharp = expected[k];
    if (!sharp) continue;
    DerivativeElement &element = result_.elements[k];
    ++element.judged;
    auto const wanted = static_cast<double>(*sharp);
    double const scale = std::max(1.0, std::abs(wanted));
    double const rounding =
        std::abs(static_cast<double>(values[differentiated_.results[first + k]] - (*exact)[first + k]));
    double const error = std::abs(found[k] - wanted) / scale;
    bool const is_different = !(error <= result_.tolerance + most_rounding * rounding / scale);
    element.different += is_different;
    if (!(error <= element.error) && (is_different || element.different == 0)) {
      element.error = error, element.expected = wanted, element.found = found[k];
      element.worst = sample;
    }
  }
}

} // namespace symreal::program
