// Helpers that the statements of a call use.
#include "tool/calls/call_binding.h"

#include <fmt/format.h>

namespace symreal::tool {

std::string binding_helpers(bool is_c) {
  std::string value = "static double symreal_default(void) {\n"
                      "  static int symreal_last = 0;\n"
                      "  symreal_last = (symreal_last + 61) % 97;\n"
                      "  return (symreal_last + 1) / 100.0;\n"
                      "}\n";
  if (is_c) return value;
  std::string text = "#include <iterator>\n" + value + R"(namespace {
template <int symreal_n> struct symreal_rank : symreal_rank<symreal_n - 1> {};
template <> struct symreal_rank<0> {};
template <class symreal_T, class symreal_Value>
void symreal_fill(symreal_T &&symreal_object, symreal_Value symreal_value);
)";
  for (char const *type : {"double", "float", "bool", "char", "int", "unsigned", "long", "unsigned long"})
    text +=
        fmt::format("template <class symreal_Value> void symreal_put({} &symreal_object, symreal_Value symreal_value, "
                    "symreal_rank<3>) {{\n  symreal_object = symreal_value();\n}}\n",
                    type);
  return text + R"(template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<2>)
    -> decltype(symreal_object.rows(), symreal_object.cols(), static_cast<void>(symreal_object(0, 0))) {
  for (decltype(symreal_object.rows() + 0) symreal_i = 0; symreal_i < symreal_object.rows(); ++symreal_i)
    for (decltype(symreal_object.cols() + 0) symreal_j = 0; symreal_j < symreal_object.cols(); ++symreal_j)
      symreal_fill(symreal_object(symreal_i, symreal_j), symreal_value);
}
template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<1>)
    -> decltype(symreal_object.real(), static_cast<void>(symreal_object.imag())) {
  symreal_object = symreal_T(symreal_value(), symreal_value());
}
template <class symreal_T, class symreal_Value>
auto symreal_put(symreal_T &symreal_object, symreal_Value symreal_value, symreal_rank<0>)
    -> decltype(static_cast<void>(*std::begin(symreal_object))) {
  for (auto &symreal_part : symreal_object) symreal_fill(symreal_part, symreal_value);
}
template <class symreal_T, class symreal_Value>
void symreal_fill(symreal_T &&symreal_object, symreal_Value symreal_value) {
  symreal_put(symreal_object, symreal_value, symreal_rank<3>());
}
}
)";
}

} // namespace symreal::tool
