// Candidates for common subexpressions: sums of two terms that divide other sums, and products of two atoms.
//
// In terms of logic synthesis: two-term kernels and two-literal cubes, found as in the fast extraction of Rajski and
// Vasudevamurthy. Each candidate counts the operations that it saves.
#pragma once

#include "engine/optimise/algebra/key_table.h"

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace symreal::algebra {

using CandidateId = std::uint32_t;

struct Candidate {
  std::uint64_t key;
  bool is_pair; // a product of two atoms, else a sum
  std::uint32_t first_atom, second_atom;
  int saving = 0; // total of all uses
  int cost;       // of one computation
  int level = 0;  // current bucket
  std::uint32_t last_use = KeyTable::none;

  int gain() const { return saving - cost; }
};

// Bucket queue of candidates by gain. An outdated gain is corrected when its candidate is taken.
class Candidates {
public:
  // `noise` is the probability of a near-best candidate. `sums_first` breaks ties in favour of sums.
  Candidates(std::mt19937_64 &random, double noise, bool sums_first)
      : random_(random),
        noise_(noise),
        sums_first_(sums_first) {}

  // Adds or removes a use of the candidate with this key.
  void add(Candidate const &made, int saving, std::uint32_t expression);
  void remove(std::uint64_t key, int saving);

  // The best or a near-best candidate; nullopt if no candidate saves anything.
  std::optional<Candidate> take();
  // Expressions that may use the candidate, ascending.
  std::vector<std::uint32_t> uses(Candidate const &candidate) const;

private:
  struct Use {
    std::uint32_t expression, previous;
  };

  int level_of(Candidate const &candidate) const;
  void enqueue(CandidateId id);

  std::mt19937_64 &random_;
  double noise_;
  bool sums_first_;
  KeyTable numbers_;
  std::vector<Candidate> candidates_;
  std::vector<Use> uses_;
  std::vector<std::vector<CandidateId>> waiting_; // indexed by level
  int highest_ = 0;
};

} // namespace symreal::algebra
