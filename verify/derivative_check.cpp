// Check of derivatives: compares them with finite differences and dual numbers of the recorded graph.
#include "engine/graph/extended.h"
#include "engine/graph/implicit.h"
#include "engine/optimise/differentiate/differences.h"
#include "engine/optimise/differentiate/differentiate.h"
#include "engine/optimise/differentiate/dual_numbers.h"
#include "verify/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symreal::program {

namespace {

constexpr std::size_t least_samples = 4, most_samples = 500;
constexpr double usual_operations = 4e7; // operations in extended precision: a few seconds
constexpr double most_operations = 4e8;  // limit while required samples are missing or some element is unjudged
constexpr double most_off_duals = 1e-12; // relative to max(magnitude, 1), if the mode promises equal numbers
constexpr double far = 1024; // magnitude of an input beyond which proportional steps may miss features of the function
constexpr double low_kink = 1000;    // multiple of the error that differences may have
constexpr double most_rounding = 64; // multiple of the rounding error before any pass

constexpr std::uint32_t no_input = ~std::uint32_t{0};

std::string obstacle(Differences const &differences, Banner const &banner) {
  if (banner.is_single) return "the code is in single precision";
  return differences.obstacle();
}

// The original has no derivatives, so that modes which promise equal numbers get the usual tolerance.
double derivative_tolerance(Subject const &subject) {
  return subject.banner.mode == FloatingPoint::fast ? subject.options.tolerance : VerificationOptions().tolerance;
}

CallExternal program_calls(Subject const &subject) {
  if (!subject.in_program) return {};
  return [program = subject.original.get()](std::size_t function, std::span<double const> arguments,
                                            std::span<double> results) { program->call(function, arguments, results); };
}

class Derivatives final : public Check {
public:
  // Throws derivative_unverified for code in single precision and for graphs that extended precision cannot evaluate.
  Derivatives(Subject &subject, Verification &result);

  // Leaves samples out once the time budget is spent.
  bool compare(CheckedSample const &on) override;

private:
  using Shared = std::shared_ptr<Sample const>;

  bool is_at_end() const;
  bool is_far(std::size_t element, Sample const &sample) const;
  void compare_with_formulas(Shared const &sample, std::span<double const> promised, std::span<double const> found);
  // Does `found` differ from `wanted` by more than is allowed?
  static bool is_off(double wanted, double found, double allowed, double rounding);
  static void judge(DerivativeElement &element, Shared const &sample, double wanted, double found, double allowed,
                    double rounding, bool is_by_differences);
  // Expands packed matrices: one number for each element of each derivative.
  std::vector<double> unpacked(std::vector<double> const &stored) const;

  Subject const &subject_;
  CallExternal call_; // calls the program's functions
  Differences differences_;
  DualNumbers duals_;
  Graph differentiated_; // formulas before any pass; also measure the rounding error at a sample
  FloatingPoint mode_;
  // The derivatives of solvers' results are not those of the executed operations, so differences alone judge.
  bool is_implicit_;
  std::vector<double> off_differences_; // per element: error that differences may have
  // Per element: the slots of the inputs that it is differentiated by; the same slot twice for a first derivative.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_;
  std::size_t usual_ = 0, most_ = 0; // samples: usual number, and number if some elements are judged too rarely
  DerivativeResult &result_;
};

Derivatives::Derivatives(Subject &subject, Verification &verification)
    : subject_(subject),
      call_(program_calls(subject)),
      differences_(subject.graph, subject.banner.derivatives, call_),
      duals_(subject.graph, differences_.requests(), call_),
      differentiated_(differentiate(subject.recorded.graph, subject.banner.derivatives, [](Diagnostic const &) {})),
      mode_(subject.banner.mode),
      is_implicit_(std::ranges::any_of(subject.recorded.graph.externals, is_implicit)),
      result_(verification.derivatives.emplace()) {
  Graph const &recorded = subject.graph; // completed by the functions that give derivatives
  double const tolerance = derivative_tolerance(subject);
  if (std::string const why = obstacle(differences_, subject.banner); !why.empty())
    fail(DiagnosticId::derivative_unverified, {subject.path, 1, 1}, "the derivatives cannot be checked: " + why);
  result_.tolerance = tolerance;
  std::uint32_t next = static_cast<std::uint32_t>(recorded.output_count());
  for (DerivativeRequest const &request : differences_.requests()) {
    Object whole{request.name, request.extents(), next};
    whole.count = static_cast<std::uint32_t>(number_count(whole.extents, {}));
    next += whole.count;
    double const times = request.kind == DerivativeKind::hessian ? PointDifferences::second : 1;
    off_differences_.resize(off_differences_.size() + whole.count, times * tolerance);
    result_.objects.push_back(std::move(whole));
    std::vector<std::uint32_t> const &inputs = request.input_slots;
    bool const is_hessian = request.kind == DerivativeKind::hessian;
    std::size_t const rows = is_hessian ? inputs.size() : request.is_matrix() ? request.output_slots.size() : 1;
    if (request.kind == DerivativeKind::jvp) // directional: by all inputs
      by_.resize(off_differences_.size(), {no_input, no_input});
    else
      for (std::size_t i = 0; i < rows; ++i)
        for (std::uint32_t const input : inputs) by_.emplace_back(is_hessian ? inputs[i] : input, input);
  }
  result_.elements.resize(next - recorded.output_count());
  for (std::size_t k = 0; k < differences_.seed_count(); ++k) // distinct, in [-1, 1]
    subject.seeds.push_back(std::remainder(0.3 + 0.6180339887498949 * static_cast<double>(k), 1.0) * 2);
  std::size_t const passes = differences_.evaluations() + duals_.passes();
  double const each = std::max(1.0, static_cast<double>(recorded.nodes.size() * passes));
  most_ = std::clamp(static_cast<std::size_t>(most_operations / each), least_samples, most_samples);
  usual_ = std::clamp(static_cast<std::size_t>(usual_operations / each), std::min(least_judged * 2, most_), most_);
}

bool Derivatives::is_at_end() const {
  if (result_.tried < usual_) return false;
  auto const is_judged = [](DerivativeElement const &element) { return element.judged >= least_judged; };
  return result_.tried >= most_ || std::ranges::all_of(result_.elements, is_judged);
}

std::vector<double> Derivatives::unpacked(std::vector<double> const &stored) const {
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

// Compares as for any kernel, with the unoptimised derivative graph as reference.
void Derivatives::compare_with_formulas(Shared const &sample, std::span<double const> promised,
                                        std::span<double const> found) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (same(promised[k], found[k], mode_, 0)) continue;
    DerivativeElement &element = result_.elements[k];
    if (element.broken++ == 0) element.promised = promised[k], element.given = found[k], element.first_broken = sample;
  }
}

bool Derivatives::compare(CheckedSample const &on) {
  if (is_at_end()) {
    ++result_.left_out;
    return false;
  }
  Sample const &sample = on.sample;
  std::span<double const> const stored = on.derivatives;
  std::vector<double> const inputs = subject_.with_seeds(sample.inputs);
  std::vector<double> const values = evaluate(differentiated_, inputs, sample.parameters, call_);
  auto const exact =
      evaluate_extended(differentiated_, std::span<double const>(inputs), sample.parameters, values, call_);
  if (!exact) return false; // the sample lies on a decision boundary
  ++result_.tried;
  auto const shared = std::make_shared<Sample const>(sample);
  std::vector<double> formulas, rounding; // of the stored derivatives: formula values, rounding errors
  std::size_t const first = differentiated_.results.size() - stored.size();
  for (std::size_t k = 0; k < stored.size(); ++k) {
    formulas.push_back(values[differentiated_.results[first + k]]);
    rounding.push_back(std::abs(static_cast<double>(formulas[k] - (*exact)[first + k])));
  }
  formulas = unpacked(formulas), rounding = unpacked(rounding);
  std::vector<double> const found = unpacked({stored.begin(), stored.end()});
  if (mode_ != FloatingPoint::fast && check_premises(differentiated_, values).hold_in(mode_)) {
    ++result_.promised;
    compare_with_formulas(shared, formulas, found);
  }
  auto const seeds = differences_.seeds_of_requests(subject_.seeds);
  std::vector<long double> const duals =
      is_implicit_ ? std::vector<long double>(found.size()) : duals_.at(seeds, sample.inputs, sample.parameters);
  std::vector<SharpNumber> const sharp = differences_.at(inputs, sample.parameters, result_.tolerance);
  internal_check(sharp.size() == found.size() && duals.size() == found.size());
  double const least = mode_ == FloatingPoint::fast ? result_.tolerance : most_off_duals;
  for (std::size_t k = 0; k < found.size(); ++k) {
    DerivativeElement &element = result_.elements[k];
    auto const dual = static_cast<double>(duals[k]);
    bool const has_dual = std::isfinite(dual) && !is_implicit_;
    if (has_dual) judge(element, shared, dual, found[k], least, rounding[k], false);
    SharpNumber const &one = sharp[k];
    if (!one) continue;
    auto const difference = static_cast<double>(*one);
    // Steps that leap over a feature agree with each other but not with the derivative, and a low kink hides behind
    // curvature: dual numbers decide there.
    bool const may_err =
        is_far(k, sample) || !is_off(difference, found[k], low_kink * off_differences_[k], rounding[k]);
    if (has_dual && may_err && is_off(difference, found[k], off_differences_[k], rounding[k]) &&
        !is_off(dual, found[k], least, rounding[k]))
      continue;
    ++element.judged;
    judge(element, shared, difference, found[k], off_differences_[k], rounding[k], true);
  }
  return false;
}

bool Derivatives::is_far(std::size_t element, Sample const &sample) const {
  auto const [one, other] = by_[element];
  auto const beyond = [](double input) { return std::abs(input) > far; };
  if (one == no_input) return std::ranges::any_of(sample.inputs, beyond);
  return beyond(sample.inputs[one]) || beyond(sample.inputs[other]);
}

bool Derivatives::is_off(double wanted, double found, double allowed, double rounding) {
  double const scale = std::max(1.0, std::abs(wanted));
  return !(std::abs(found - wanted) / scale <= allowed + most_rounding * rounding / scale);
}

void Derivatives::judge(DerivativeElement &element, Shared const &sample, double wanted, double found, double allowed,
                        double rounding, bool is_by_differences) {
  double const scale = std::max(1.0, std::abs(wanted)), error = std::abs(found - wanted) / scale;
  double const most = allowed + most_rounding * rounding / scale;
  bool const is_different = is_off(wanted, found, allowed, rounding);
  element.different += is_different;
  double share = is_different ? std::max(error / most, std::nextafter(1.0, 2.0)) : std::isinf(most) ? 0 : error / most;
  if (std::isnan(share)) share = std::numeric_limits<double>::infinity();
  if (share <= element.error) return;
  element.error = share, element.expected = wanted, element.found = found;
  element.is_by_differences = is_by_differences;
  element.worst = sample;
}

} // namespace

std::unique_ptr<Check> check_derivatives(Subject &subject, Verification &result) {
  return subject.banner.derivatives.empty() ? nullptr : std::make_unique<Derivatives>(subject, result);
}

} // namespace symreal::program
