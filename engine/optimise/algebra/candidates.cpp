#include "engine/optimise/algebra/candidates.h"

#include <algorithm>

namespace symreal::algebra {

int Candidates::level_of(Candidate const &candidate) const {
  return 2 * candidate.gain() - (candidate.is_pair && sums_first_ ? 1 : 0);
}

void Candidates::enqueue(CandidateId id) {
  Candidate &candidate = candidates_[id];
  int const level = level_of(candidate);
  if (level <= 0 || level <= candidate.level) return;
  candidate.level = level;
  if (waiting_.size() <= static_cast<std::size_t>(level)) waiting_.resize(level + 1);
  waiting_[level].push_back(id);
  highest_ = std::max(highest_, level);
}

void Candidates::add(Candidate const &made, int saving, std::uint32_t expression) {
  std::uint32_t &number = numbers_[made.key];
  if (number == KeyTable::none) {
    number = static_cast<CandidateId>(candidates_.size());
    candidates_.push_back(made);
  }
  CandidateId const id = number;
  Candidate &candidate = candidates_[id];
  candidate.saving += saving;
  if (candidate.last_use == KeyTable::none || uses_[candidate.last_use].expression != expression) {
    uses_.push_back({expression, candidate.last_use});
    candidate.last_use = static_cast<std::uint32_t>(uses_.size() - 1);
  }
  enqueue(id);
}

void Candidates::remove(std::uint64_t key, int saving) {
  if (CandidateId const id = numbers_.find(key); id != KeyTable::none) candidates_[id].saving -= saving;
}

std::optional<Candidate> Candidates::take() {
  while (true) {
    while (highest_ > 0 && waiting_[highest_].empty()) --highest_;
    if (highest_ <= 0) return std::nullopt;
    int level = highest_;
    if (noise_ > 0 && static_cast<double>(random_() >> 11) * 0x1p-53 < noise_)
      for (int lower : {highest_ - 1, highest_ - 2})
        if (lower > 0 && !waiting_[lower].empty()) {
          level = lower;
          break;
        }
    std::vector<CandidateId> &bucket = waiting_[level];
    std::swap(bucket[random_() % bucket.size()], bucket.back());
    CandidateId const id = bucket.back();
    bucket.pop_back();
    Candidate &candidate = candidates_[id];
    if (candidate.level == level) candidate.level = 0;
    int const now = level_of(candidate);
    if (now == level) return candidate;
    if (now > 0 && now < level) enqueue(id);
  }
}

std::vector<std::uint32_t> Candidates::uses(Candidate const &candidate) const {
  std::vector<std::uint32_t> expressions;
  for (std::uint32_t use = candidate.last_use; use != KeyTable::none; use = uses_[use].previous)
    expressions.push_back(uses_[use].expression);
  std::ranges::sort(expressions);
  auto const repeated = std::ranges::unique(expressions);
  expressions.erase(repeated.begin(), repeated.end());
  return expressions;
}

} // namespace symreal::algebra
