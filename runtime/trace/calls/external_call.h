// Numbers that a solver has found and the residual that is 0 there, as the program says by `implicit(x, r)`: a call of
// an implicit function. See engine/graph/implicit.h.
#pragma once

#include "engine/graph/external.h"

#include <symreal/real_number.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace symreal::trace {

// Descriptions of external functions, read.
struct ExternalShapes {
  struct Shape {
    External external;
    std::vector<std::string> sizes; // per parameter, or empty
  };
  using Key = std::tuple<char const *, char const *, bool>; // literals of the program
  std::map<Key, Shape> known;
};

class Implicit {
public:
  void begin(std::string const &label, Place const &place);
  bool is_open() const { return is_open_; }
  void element(RealNumber *number);
  // Ends the second object; the unknowns then hold the call's results.
  void end();

private:
  struct Part {
    std::string label;
    Place place;
    std::vector<RealNumber *> places;
    std::vector<RealNumber> numbers; // a residual may be a temporary
  };
  void relate(Part const &unknown, Part const &residual) const;

  std::vector<Part> parts_;
  bool is_open_ = false;
};

} // namespace symreal::trace
