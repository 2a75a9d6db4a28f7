#include <symreal/standard_library.h>

#include <istream>
#include <ostream>

namespace symreal::types {

std::ostream &operator<<(std::ostream &out, RealNumber x) { return out << value(x); }

std::istream &operator>>(std::istream &in, RealNumber &x) {
  double number = 0;
  in >> number;
  x = number;
  return in;
}

} // namespace symreal::types
