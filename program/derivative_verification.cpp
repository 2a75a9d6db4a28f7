#include "program/derivative_verification.h"

#include "differentiate/differentiate.h"
#include "differentiate/dual_numbers.h"
#include "differentiate/stored_matrix.h"
#include "graph/evaluate.h"
#include "graph/extended.h"
#include "graph/implicit.h"
#include "verify/compare.h"

#include <algorithm>
#include <cmath>

namespace symreal::program {

namespace {

constexpr std::size_t most_samples = 200;
constexpr double most_operations = 4e7;  // in extended precision: a few seconds
constexpr double most_off_duals = 1e-12; // of the larger of the magnitude and 1, where equal numbers are promised
constexpr double most_rounding = 64;     // times as much as the derivative loses before any pass

std::string obstacle(Differences const &differences, Banner const &banner) {
  if (banner.is_single) return "the code is in single precision";
  return differences.obstacle();
}

} // namespace

DerivativeVerification::DerivativeVerification(Graph const &recorded, Graph const &marked, std::string const &path,
                                               Banner const &banner, double tolerance, CallExternal const &call)
    : recorded_(recorded),
      call_(call),
      differences_(recorded, banner.derivatives, call),
      differentiated_(differentiate(marked, banner.derivatives, [](Diagnostic const &) {})),
      mode_(banner.mode),
      is_implicit_(std::ranges::any_of(marked.externals, is_implicit)) {
  if (std::string const why = obstacle(differences_, banner); !why.empty())
    fail(DiagnosticId::derivative_unverified, {path, 1, 1}, "the derivatives cannot be checked: " + why);
  result_.tolerance = tolerance;
  std::uint32_t next = static_cast<std::uint32_t>(recorded.output_count());
  for (DerivativeRequest const &request : differences_.requests()) {
    Object whole{request.name, request.extents(), next};
    whole.count = static_cast<std::uint32_t>(number_count(whole.extents, {}));
    next += whole.count;
    double const times = request.kind == DerivativeKind::hessian ? PointDifferences::second : 1;
    off_differences_.resize(off_differences_.size() + whole.count, times * tolerance);
    result_.objects.push_back(std::move(whole));
  }
  result_.elements.resize(next - recorded.output_count());
  for (std::size_t k = 0; k < differences_.seed_count(); ++k) // between -1 and 1, no two alike
    seeds_.push_back(std::remainder(0.3 + 0.6180339887498949 * static_cast<double>(k), 1.0) * 2);
  double const each = static_cast<double>(recorded.nodes.size() * differences_.evaluations());
  most_ = std::clamp(static_cast<std::size_t>(most_operations / std::max(each, 1.0)), least_judged * 2, most_samples);
}

std::vector<double> DerivativeVerification::with_seeds(std::vector<double> inputs) const {
  inputs.insert(inputs.end(), seeds_.begin(), seeds_.end());
  return inputs;
}

std::vector<double> DerivativeVerification::unpacked(std::vector<double> const &stored) const {
  std::size_t const recorded = differentiated_.outputs.size() - result_.objects.size();
  std::span<double const> rest = stored;
  std::vector<double> result;
  for (std::size_t k = recorded; k < differentiated_.outputs.size(); ++k) {
    auto const own = rest.first(differentiated_.outputs[k].count);
    rest = rest.subspan(own.size());
    auto const matrix = std::ranges::find(differentiated_.matrices, k, &DerivativeMatrix::output);
    std::vector<double> const whole = matrix == differentiated_.matrices.end() ? std::vector(own.begin(), own.end())
                                                                               : symreal::unpacked(*matrix, own);
    result.insert(result.end(), whole.begin(), whole.end());
  }
  return result;
}

// As of any kernel, but that the reference is the graph with its derivatives.
void DerivativeVerification::compare_with_formulas(Sample const &sample, std::span<double const> promised,
                                                   std::span<double const> found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (same(promised[k], found[k], mode_, 0)) continue;
    DerivativeElement &element = result_.elements[k];
    if (element.broken++ == 0) element.promised = promised[k], element.given = found[k], element.first_broken = sample;
  }
}

void DerivativeVerification::compare(Sample const &sample, std::span<double const> stored) {
  if (result_.tried == most_) return;
  std::vector<double> const inputs = with_seeds(sample.inputs);
  std::vector<double> const values = evaluate(differentiated_, inputs, sample.parameters, call_);
  auto const exact =
      evaluate_extended(differentiated_, std::span<double const>(inputs), sample.parameters, values, call_);
  if (!exact) return; // at a decision
  ++result_.tried;
  std::vector<double> formulas, rounding; // of what is stored: the numbers of the formulas, and how far off they are
  std::size_t const first = differentiated_.results.size() - stored.size();
  for (std::size_t k = 0; k < stored.size(); ++k) {
    formulas.push_back(values[differentiated_.results[first + k]]);
    rounding.push_back(std::abs(static_cast<double>(formulas[k] - (*exact)[first + k])));
  }
  formulas = unpacked(formulas), rounding = unpacked(rounding);
  std::vector<double> const found = unpacked({stored.begin(), stored.end()});
  if (mode_ != FloatingPoint::fast && check_premises(differentiated_, values).hold_in(mode_)) {
    ++result_.promised;
    compare_with_formulas(sample, formulas, found);
  }
  auto const seeds = differences_.seeds_of_requests(seeds_);
  std::vector<long double> const duals =
      dual_numbers(recorded_, differences_.requests(), seeds, sample.inputs, sample.parameters, call_);
  std::vector<SharpNumber> const sharp = differences_.at(inputs, sample.parameters, result_.tolerance);
  internal_check(sharp.size() == found.size() && duals.size() == found.size());
  double const least = mode_ == FloatingPoint::fast ? result_.tolerance : most_off_duals;
  for (std::size_t k = 0; k < found.size(); ++k) {
    DerivativeElement &element = result_.elements[k];
    auto const dual = static_cast<double>(duals[k]);
    if (std::isfinite(dual) && !is_implicit_) judge(element, sample, dual, found[k], least, rounding[k], false);
    SharpNumber const &difference = sharp[k];
    if (!difference) continue;
    ++element.judged;
    judge(element, sample, static_cast<double>(*difference), found[k], off_differences_[k], rounding[k], true);
  }
}

// The error that is kept is that from dual numbers, which have no steps, unless the differences tell another story.
void DerivativeVerification::judge(DerivativeElement &element, Sample const &sample, double wanted, double found,
                                   double allowed, double rounding, bool is_by_differences) {
  double const scale = std::max(1.0, std::abs(wanted)), error = std::abs(found - wanted) / scale;
  bool const is_different = !(error <= allowed + most_rounding * rounding / scale);
  if (is_by_differences && !is_different) return;
  element.different += is_different;
  if (error <= element.error || (!is_different && element.different != 0)) return;
  element.error = error, element.expected = wanted, element.found = found;
  element.is_by_differences = is_by_differences;
  element.worst = sample;
}

} // namespace symreal::program
