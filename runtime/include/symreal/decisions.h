// What becomes of a decision on a symbolic value: chosen for the whole program by the driver (--decisions), for a
// statement or a function by a pragma.
#pragma once

#include <symreal/real_number.h>

namespace symreal {

enum class Decisions {
  error,   // the program goes on with the carried value, and every such place is reported
  guard,   // the path taken is recorded with its conditions
  select,  // both arms are recorded where the source allows it; elsewhere as error
  explore, // one path, which the driver chooses among all: it runs the program once for each
  best,    // select where the source allows it, elsewhere explore, and guard what has no paths: conversions
  carry, // the carried value is taken, and the place noted: the word of a pragma that no output depends on the outcome
};

// The policy of the calling thread at this moment.
Decisions decisions() noexcept;

// Another policy until the end of a scope.
class DecisionScope {
public:
  explicit DecisionScope(Decisions policy) noexcept;
  DecisionScope(DecisionScope const &) = delete;
  DecisionScope &operator=(DecisionScope const &) = delete;
  ~DecisionScope();

private:
  int before_;
};

// Until the end of a scope even mode fast keeps operations as they are written.
class ExactScope {
public:
  ExactScope() noexcept;
  ExactScope(ExactScope const &) = delete;
  ExactScope &operator=(ExactScope const &) = delete;
  ~ExactScope();

private:
  bool before_;
};

// While it lives, statements are executed under a condition (the arm of a select): guards that are met hold only where
// the condition does.
class PathScope {
public:
  explicit PathScope(SymbolicBool condition) noexcept;
  PathScope(PathScope const &) = delete;
  PathScope &operator=(PathScope const &) = delete;
  ~PathScope();

private:
  RealNumber before_;
};

// Makes the condition a guard of the kernel: it must hold whenever the generated code is run, on the current path.
void require(SymbolicBool condition) noexcept;

} // namespace symreal
