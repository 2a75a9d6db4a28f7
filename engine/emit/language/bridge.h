// Bridges: local functions by which a language calls external functions. A bridge takes the arguments as one array and
// stores the results in another. C needs no bridges.
//
// In patterns $name is the bridge, $c_name the function; a parameter is $p (p0, p1, ...), of $count numbers, at $at ..
// $last of the arguments, or of the results if it is written ($next: the index after them).
#pragma once

#include <span>
#include <string_view>

namespace symreal {

// A parameter in a function's declaration, and as an argument of its call.
struct Passing {
  std::string_view declared = {}, passed = {};
};

// An integer type: its names in C and in the language.
struct BridgeInteger {
  std::string_view c = {}, type = {};
  std::string_view to = {}, from = {}; // $value $type: converts from and to a number; empty: the default
};

struct BridgeSyntax {
  std::span<BridgeInteger const> integers = {};
  std::string_view to_integer = {}, from_integer = {};                     // $value $type
  Passing number = {}, integer = {}, input = {}, output = {}, object = {}; // $type, $value: of an integer, converted
  std::string_view copy = {}; // $from $from_last $from_next: before the call, for parameters that are read and written
  // Return types: $type of an integer, $count of the numbers of a struct.
  std::string_view no_result = {}, number_result = {}, integer_result = {}, object_result = {};
  // The call, $made, with the store of its return value: from the first result on.
  std::string_view no_store = {}, number_store = {}, object_store = {}; // integers are converted to numbers
  std::string_view object_local = {};                                   // $count: declares the variable of object_store
  std::string_view made = {}, made_without_result = {};   // $declared $passed $result; the latter if it differs
  std::string_view structure = {}, import_structure = {}; // $count: a struct; its name, if a declaration needs it
  // Declarations of all functions: $structures $names, and $declared of the parameters, $result; the variant without a
  // result, if it differs.
  std::string_view begin = {}, declaration = {}, declaration_without_result = {}, end = {};
  std::string_view bridge = {}; // $locals $copies $stored $argument_count $result_count
  std::string_view call = {};   // $arguments $array $first $next: calls the bridge

  bool is_given() const { return !call.empty(); }
};

} // namespace symreal
