// Verification of derivatives in generated code: compares them with finite differences of the recorded graph.
#pragma once

#include "engine/optimise/differentiate/differences.h"
#include "engine/optimise/differentiate/dual_numbers.h"
#include "runtime/replay/samples.h"
#include "verify/generated_code.h"

#include <memory>
#include <span>

namespace symreal::program {

// Verdict on one element of a derivative after the samples so far.
struct DerivativeElement {
  // Samples whose differences are sharp enough to judge by; samples that differ from those, or from dual numbers.
  std::size_t judged = 0, different = 0;
  // Worst error, as a fraction of the error allowed there; expected and found values; the reference that gave them.
  double error = 0, expected = 0, found = 0;
  bool is_by_differences = false;
  std::shared_ptr<Sample const> worst = {};
  // Samples on which it differs from the unoptimised formulas, which the mode promises to keep; the first such sample:
  std::size_t broken = 0;
  double promised = 0, given = 0;
  std::shared_ptr<Sample const> first_broken = {};
};

struct DerivativeResult {
  // Derivative objects, matrices in full even if stored packed; their slots follow the original's.
  std::vector<Object> objects;
  std::vector<DerivativeElement> elements;
  std::size_t tried = 0, promised = 0; // samples, and those on which the mode promises equal numbers
  std::size_t left_out = 0;            // samples that would have taken too long
  double tolerance = 0;
};

class DerivativeVerification {
public:
  // Throws derivative_unverified for code in single precision and for graphs that extended precision cannot evaluate.
  // `recorded` outlives this object and has the functions that give derivatives; `call` calls the program's functions.
  // `marked` is the same graph with the solvers' results marked: their derivatives are not those of the executed
  // operations, so differences alone judge.
  DerivativeVerification(Graph const &recorded, Graph const &marked, std::string const &path, Banner const &banner,
                         double tolerance, CallExternal const &call);

  // The inputs with the seeds appended; the seeds are the same in every call.
  std::vector<double> with_seeds(std::vector<double> inputs) const;
  // `stored`: the derivative outputs at a sample within the premises and all guards. Leaves samples out once the time
  // budget is spent.
  void compare(Sample const &sample, std::span<double const> stored);
  DerivativeResult const &result() const { return result_; }

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

  CallExternal call_;
  Differences differences_;
  DualNumbers duals_;
  Graph differentiated_; // formulas before any pass; also measure the rounding error at a sample
  FloatingPoint mode_;
  bool is_implicit_;
  DerivativeResult result_;
  std::vector<double> off_differences_; // per element: error that differences may have
  // Per element: the slots of the inputs that it is differentiated by; the same slot twice for a first derivative.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_;
  std::vector<double> seeds_;
  std::size_t usual_ = 0, most_ = 0; // samples: usual number, and number if some elements are judged too rarely
};

// An element with fewer judged samples (or fewer than half of those tried, if that is less) counts as unverified.
inline constexpr std::size_t least_judged = 10;

} // namespace symreal::program
