// Joins the verifications of several shards.
#include "verify/verification.h"

#include <algorithm>

namespace symreal::program {

static void join(std::vector<OutputComparison> &all, std::vector<OutputComparison> const &others) {
  for (std::size_t slot = 0; slot < all.size(); ++slot) all[slot].join(others[slot]);
}

static void keep_larger(std::vector<std::uint64_t> &all, std::vector<std::uint64_t> const &others) {
  for (std::size_t slot = 0; slot < all.size(); ++slot) all[slot] = std::max(all[slot], others[slot]);
}

static void add(std::vector<LeftState> &all, std::vector<LeftState> const &others) {
  for (LeftState const &left : others) {
    auto const found = std::ranges::find(all, left.name, &LeftState::name);
    if (found == all.end())
      all.push_back(left);
    else
      found->samples += left.samples;
  }
}

static void join(ExactJudgement &all, ExactJudgement const &other) {
  if (all.obstacle.empty()) all.obstacle = other.obstacle;
  all.calls += other.calls;
  all.untold += other.untold;
  for (std::size_t slot = 0; slot < all.outputs.size(); ++slot) {
    OutputErrors &one = all.outputs[slot];
    OutputErrors const &more = other.outputs[slot];
    one.calls += more.calls;
    one.original = std::max(one.original, more.original);
    one.generated = std::max(one.generated, more.generated);
    if (more.failed_generated > one.failed_generated) {
      one.failed_generated = more.failed_generated;
      one.failed_original = more.failed_original;
    }
  }
}

static void join_mathematics(std::string &all, std::string const &other) {
  if (all.find(other) == all.npos) all += "; " + other;
}

static void join(Verification &all, ThreadResult const &threads) {
  if (!all.threads)
    all.threads = threads;
  else
    all.threads->different += threads.different;
}

static void join(BranchResult &all, BranchResult const &other) {
  if (all.obstacle.empty()) all.obstacle = other.obstacle;
  add(all.branches, other.branches);
}

static void join(DerivativeElement &all, DerivativeElement const &other) {
  if (other.error > all.error) {
    all.error = other.error, all.expected = other.expected, all.found = other.found;
    all.is_by_differences = other.is_by_differences, all.worst = other.worst;
  }
  if (all.broken == 0) all.promised = other.promised, all.given = other.given, all.first_broken = other.first_broken;
  all.judged += other.judged;
  all.different += other.different;
  all.broken += other.broken;
}

static void join(DerivativeResult &all, DerivativeResult const &other) {
  all.tried += other.tried;
  all.promised += other.promised;
  all.left_out += other.left_out;
  for (std::size_t k = 0; k < all.elements.size(); ++k) join(all.elements[k], other.elements.at(k));
}

void join(Verification &verification, Verification const &other) {
  for (auto const member :
       {&Verification::inside, &Verification::not_finite, &Verification::zero_sign, &Verification::undefined,
        &Verification::outside_different, &Verification::graph_different, &Verification::decided_otherwise,
        &Verification::tried, &Verification::around, &Verification::refused, &Verification::guards_different,
        &Verification::next_call_different})
    verification.*member += other.*member;
  join_mathematics(verification.mathematics, other.mathematics);
  for (std::size_t slot = 0; slot < verification.lost.size(); ++slot) verification.lost[slot] += other.lost[slot];
  join(verification.outputs, other.outputs);
  join(verification.rewritten, other.rewritten);
  join(verification.called_again, other.called_again);
  join(verification.called_beyond, other.called_beyond);
  join(verification.wrapped, other.wrapped);
  keep_larger(verification.own_flags_ulp, other.own_flags_ulp);
  keep_larger(verification.own_code_ulp, other.own_code_ulp);
  verification.named.insert(other.named.begin(), other.named.end());
  for (std::size_t k = 0; k < verification.decisions.size(); ++k) {
    verification.decisions[k].counts.yes += other.decisions[k].counts.yes;
    verification.decisions[k].counts.no += other.decisions[k].counts.no;
  }
  verification.crossed = std::max(verification.crossed, other.crossed);
  if (verification.branches && other.branches) join(*verification.branches, *other.branches);
  if (verification.errors && other.errors) join(*verification.errors, *other.errors);
  add(verification.left, other.left);
  add(verification.unnamed, other.unnamed);
  add(verification.overwritten, other.overwritten);
  for (auto const member : {&Verification::unexamined, &Verification::next_call_ended, &Verification::next_call_missed})
    if ((verification.*member).empty()) verification.*member = other.*member;
  add(verification.changes_outside, other.changes_outside);
  add(verification.outside, other.outside);
  add(verification.left_by_wrapper, other.left_by_wrapper);
  add(verification.missed_by_wrapper, other.missed_by_wrapper);
  for (std::size_t k = 0; k < verification.guards.size(); ++k) verification.guards[k].failed += other.guards[k].failed;
  if (other.guard_mismatch &&
      (!verification.guard_mismatch || other.guard_mismatch->sample < verification.guard_mismatch->sample))
    verification.guard_mismatch = other.guard_mismatch;
  if (other.threads) join(verification, *other.threads);
  join(verification.exact, other.exact);
  if (verification.derivatives && other.derivatives) join(*verification.derivatives, *other.derivatives);
}

} // namespace symreal::program
