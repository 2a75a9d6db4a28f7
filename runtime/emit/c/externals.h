// Tables and external functions in C. Shared by emit_c and by verification, which calls the functions by themselves.
#pragma once

#include "graph/graph.h"

#include <string>
#include <vector>

namespace symreal {

// What the live part of the graph refers to: the tables, and a declaration of each function. Parameters are declared by
// what they consist of, doubles; that is how a program passes structs and arrays of doubles.
std::string c_declarations(Graph const &graph);

// Where the results of a call are kept: from element `first` of an array on.
struct ResultArray {
  std::string name;
  std::size_t first = 0;
};

// The statements of a call, with `label` in the names of its local arrays. `arguments`: an expression for each.
// `is_wanted`: whether somebody reads the returned value.
std::vector<std::string> c_call(External const &external, std::string const &label,
                                std::vector<std::string> const &arguments, ResultArray const &results, bool is_wanted);

// A C file with a function for each external one, which takes its arguments and gives its results as flat arrays:
//   void symreal_call_<number>(double const *argument, double *result);
std::string c_external_calls(Graph const &graph);

} // namespace symreal
