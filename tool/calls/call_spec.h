// One-line description of a call: a function, its arguments, and the wanted outputs.
//
//   inverse_dynamics(q[0:6]=0.3, qd[0:6]=-1..1, n=6, parameter m=1.2) -> tau[0:6]
//   veh::Bicycle(2.7, 1.1).derivative(x[0:4]={1, 2, 3, 4}, u[0:2]) -> dx[0:4]
//   scale(double const *, int)(x[0:n], n=3) -> return
//   Gain(2.0)(x=0.5) -> return                        the call operator of an object
//   norm<double, 3>(x[0:3]) -> return                 with all arguments of a template
//   operator*(a, b) -> return
#pragma once

#include "rewrite/rewrite.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::tool {

struct CallSpec {
  struct Item {
    std::string kind;             // input, parameter, constant, scratch or output
    rewrite::ConfiguredText text; // the pragma's item
    std::string base;             // first name in it
    std::string path;             // text before its sections
    std::vector<rewrite::Section> sections;
    std::vector<std::string> behind; // text behind each section
    std::string value;               // an expression, or the elements of a braced list; empty if not given
    bool is_list = false;
    std::optional<std::pair<rewrite::ConfiguredText, rewrite::ConfiguredText>> range;
    bool has_value() const { return !value.empty() || range; }
  };
  rewrite::ConfiguredText function;  // with scopes, without template arguments
  std::string template_arguments;    // with brackets; empty if not given
  std::string types;                 // parameter types in parentheses; empty if not given
  std::optional<std::string> object; // object expression of a method call
  // f(a)(x) may be f with parameters of types (a), or the call operator of object f(a); then this is the object.
  std::string called_object;
  std::vector<Item> items; // outputs last
  Place end;               // place behind the last word
};

// Is this a call rather than the name of a kernel?
bool is_call_spec(std::string const &text);

// Parses `text` at its place (column 1 is the first on a command line). Throws call_specification.
CallSpec parse_call_spec(rewrite::ConfiguredText const &text);

} // namespace symreal::tool
