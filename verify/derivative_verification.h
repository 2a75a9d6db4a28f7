// Derivatives in generated code, against differences of the recorded graph: the original has none to compare with.
#pragma once

#include "engine/optimise/differentiate/differences.h"
#include "engine/optimise/differentiate/dual_numbers.h"
#include "runtime/replay/samples.h"
#include "verify/generated_code.h"

#include <memory>
#include <span>

namespace symreal::program {

// What is known of one element after the samples so far.
struct DerivativeElement {
  // Samples: with differences that are sharp; and off these, or off dual numbers, which there are at each.
  std::size_t judged = 0, different = 0;
  // Of the worst: how far off, divided by what is allowed there, so that 1 is the most; and by what.
  double error = 0, expected = 0, found = 0;
  bool is_by_differences = false;
  std::shared_ptr<Sample const> worst = {};
  // Samples at which it is not the number that the mode promises: that of the formulas before any pass. Of the first:
  std::size_t broken = 0;
  double promised = 0, given = 0;
  std::shared_ptr<Sample const> first_broken = {};
};

struct DerivativeResult {
  // That were added, matrices as wholes, also where they are packed; their slots begin behind the original's.
  std::vector<Object> objects;
  std::vector<DerivativeElement> elements;
  std::size_t tried = 0, promised = 0; // samples, and those at which the mode promises equal numbers
  std::size_t left_out = 0;            // samples that would have taken too long
  double tolerance = 0;
};

class DerivativeVerification {
public:
  // Throws derivative_unverified for what cannot be checked at all: code in single precision, and graphs that extended
  // precision cannot evaluate. `recorded` outlives this, and has the functions that give derivatives; `call` calls
  // those of the program.
  // `marked` is the same graph, and tells what solvers have found, whose derivatives are not those of what was
  // executed: then differences alone judge.
  DerivativeVerification(Graph const &recorded, Graph const &marked, std::string const &path, Banner const &banner,
                         double tolerance, CallExternal const &call);

  // What is added to the original's inputs: the same for the same seed.
  std::vector<double> with_seeds(std::vector<double> inputs) const;
  // `stored`: the outputs that are added, at a sample within the premises and all guards. After as many samples as time
  // allows it leaves them out.
  void compare(Sample const &sample, std::span<double const> stored);
  DerivativeResult const &result() const { return result_; }

private:
  using Shared = std::shared_ptr<Sample const>;

  bool is_at_end() const;
  bool is_far(std::size_t element, Sample const &sample) const;
  void compare_with_formulas(Shared const &sample, std::span<double const> promised, std::span<double const> found);
  // Whether it is off.
  static bool is_off(double wanted, double found, double allowed, double rounding);
  static void judge(DerivativeElement &element, Shared const &sample, double wanted, double found, double allowed,
                    double rounding, bool is_by_differences);
  // Of one number for each output that is added, with all elements of matrices that are packed.
  std::vector<double> unpacked(std::vector<double> const &stored) const;

  CallExternal call_;
  Differences differences_;
  DualNumbers duals_;
  Graph differentiated_; // the formulas before any pass; they also tell how much rounding costs at a sample
  FloatingPoint mode_;
  bool is_implicit_;
  DerivativeResult result_;
  std::vector<double> off_differences_; // that an element may be
  // Of each element the slots of the inputs that it is a derivative by; the same one twice of a first derivative.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> by_;
  std::vector<double> seeds_;
  std::size_t usual_ = 0, most_ = 0; // samples: as a rule, and where some elements are judged too rarely
};

// Fewer judged samples than this, and an element counts as unverified: half of those tried, if these are fewer.
inline constexpr std::size_t least_judged = 10;

} // namespace symreal::program
