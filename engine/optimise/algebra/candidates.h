// What could be computed once: sums of two terms, which divide other sums, and products of two atoms.
//
// In the language of logic synthesis: two-term kernels and two-literal cubes, found as in the fast extraction of
// Rajski and Vasudevamurthy. Each candidate knows how many operations it saves.
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
  bool is_pair; // of atoms, in a product
  std::uint32_t first_atom, second_atom;
  int saving = 0; // over all its uses
  int cost;       // of computing it once
  int level = 0;  // under which it waits
  std::uint32_t last_use = KeyTable::none;

  int gain() const { return saving - cost; }
};

// Candidates in buckets by their gain. A gain that has fallen since is noticed when its turn comes.
class Candidates {
public:
  // `noise`: how often a candidate near the best is taken. `sums_first`: of equal gains a sum is.
  Candidates(std::mt19937_64 &random, double noise, bool sums_first)
      : random_(random),
        noise_(noise),
        sums_first_(sums_first) {}

  // The candidate with this key gains or loses a use in an expression.
  void add(Candidate const &made, int saving, std::uint32_t expression);
  void remove(std::uint64_t key, int saving);

  // The best, or nearly; nothing where none saves anything.
  std::optional<Candidate> take();
  // The expressions that may use it, in order.
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
  std::vector<std::vector<CandidateId>> waiting_; // by level
  int highest_ = 0;
};

} // namespace symreal::algebra
