// Objects that live longer than a kernel and that it touches: what they hold is baked in, or lost, unless annotated.
#pragma once

#include "graph/graph.h"

#include <cstddef>
#include <map>
#include <set>

namespace symreal::trace {

class State {
public:
  static State &current(); // one per thread

  void begin();
  void note(void *object, std::size_t size, bool is_numbers, char const *name, char const *place);
  // This number is annotated, so it is no hidden state.
  void declare(void *number) { declared_.insert(number); }
  // What is baked in. Reports state that was written and is no output, and makes its numbers ordinary again.
  std::vector<Frozen> end();

private:
  struct Touched {
    std::size_t size;
    bool is_numbers;
    std::string name;
    Place place;
    std::vector<double> values; // at the first touch
  };
  bool is_declared(void *object, Touched const &touched) const;

  std::map<void *, Touched> touched_;
  std::vector<void *> order_;
  std::set<void *> declared_;
};

} // namespace symreal::trace
