// Policies for decisions on symbolic values: the driver sets the program's (--decisions), a pragma that of a statement
// or a function.
#pragma once

#include <symreal/real_number.h>

#include <new>

namespace symreal {

enum class Decisions {
  error,   // the program goes on with the carried value, and every such place is reported
  guard,   // the path taken is recorded with its conditions
  select,  // both arms are recorded where the source allows it; elsewhere as error
  explore, // one path, which the driver chooses among all: it runs the program once for each
  best,    // select where the source allows it, elsewhere explore; guard for conversions, which have no paths
  carry, // the carried value is taken, and the place noted: the word of a pragma that no output depends on the outcome
};

// The policy of the calling thread at this moment.
Decisions decisions() noexcept;

// Scope with another policy.
class DecisionScope {
public:
  explicit DecisionScope(Decisions policy) noexcept;
  DecisionScope(DecisionScope const &) = delete;
  DecisionScope &operator=(DecisionScope const &) = delete;
  ~DecisionScope();

private:
  int before_;
};

// Scope in which even mode fast keeps operations as written.
class ExactScope {
public:
  ExactScope() noexcept;
  ExactScope(ExactScope const &) = delete;
  ExactScope &operator=(ExactScope const &) = delete;
  ~ExactScope();

private:
  bool before_;
};

// Scope whose statements are executed under a path condition (an arm of a select): its guards must hold only if the
// condition does.
class PathScope {
public:
  explicit PathScope(SymbolicBool condition) noexcept;
  PathScope(PathScope const &) = delete;
  PathScope &operator=(PathScope const &) = delete;
  ~PathScope();

private:
  RealNumber before_;
};

// Such a scope, which need not end with the block that it began in.
class OpenPathScope {
public:
  OpenPathScope() noexcept {}
  OpenPathScope(OpenPathScope const &) = delete;
  OpenPathScope &operator=(OpenPathScope const &) = delete;
  ~OpenPathScope() { end(); }

  // Requires that it has ended.
  void begin(SymbolicBool condition) noexcept {
    new (&scope_) PathScope(condition);
    is_open_ = true;
  }
  void end() noexcept {
    if (is_open_) scope_.~PathScope();
    is_open_ = false;
  }

private:
  union {
    PathScope scope_;
  };
  bool is_open_ = false;
};

// Makes the condition a guard of the kernel: it must hold whenever the generated code is run, on the current path.
void require(SymbolicBool condition) noexcept;

} // namespace symreal
