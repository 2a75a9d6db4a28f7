#include <symreal/standard_library.h>

#include <istream>
#include <ostream>
#include <sstream>

namespace symreal::types {

std::ostream &operator<<(std::ostream &out, RealNumber x) {
  double const number = x.is_node() ? detail::needed_value(x) : x.plain();
  if (x.is_node() && detail::recording) {
    std::ostringstream text; // as it will read there
    text.copyfmt(out);
    text << number;
    detail::made_stream(out, text.view(), x);
  }
  return out << number;
}

std::ostream &operator<<(std::ostream &out, SymbolicBool x) {
  detail::made_stream(out, symreal_value(x) ? "1" : "0", x.condition());
  return out << symreal_value(x);
}

std::istream &operator>>(std::istream &in, RealNumber &x) {
  double number = 0;
  in >> number;
  x = number;
  return in;
}

} // namespace symreal::types
