// A kernel that no program calls yet, in one line: the function, what it is given, and what is wanted of it.
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
    rewrite::ConfiguredText text; // the item of the pragma
    std::string base;             // its first name
    std::string path;             // what is before its sections
    std::vector<rewrite::Section> sections;
    std::vector<std::string> behind; // each of them
    std::string value;               // an expression; of a list what stands between the braces; empty: none is given
    bool is_list = false;
    std::optional<std::pair<rewrite::ConfiguredText, rewrite::ConfiguredText>> range;
    bool has_value() const { return !value.empty() || range; }
  };
  rewrite::ConfiguredText function;  // with its scopes, and without arguments of a template
  std::string template_arguments;    // with their brackets; empty: none are given
  std::string types;                 // of its parameters, in parentheses; empty: not said
  std::optional<std::string> object; // the expression whose method it is
  // f(a)(x) may be f with parameters of the types (a), or the call operator of an object; then this is the object.
  std::string called_object;
  std::vector<Item> items; // the outputs last
  Place end;               // behind the last word
};

// Is this more than the name of a kernel?
bool is_call_spec(std::string const &text);

// `text` stands at its place, the first column of which is 1 on a command line. Throws call_specification.
CallSpec parse_call_spec(rewrite::ConfiguredText const &text);

} // namespace symreal::tool
