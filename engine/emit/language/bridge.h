// How a language calls functions of libraries: by a function of the generated file for each, its bridge, which takes
// the arguments as one array and stores the results in another. C needs none.
//
// In patterns $name is the bridge, $c_name the function; a parameter is $p (p0, p1, ...), of $count numbers, which
// stand at $at .. $last of the arguments, or of the results if it is written ($next: behind them).
#pragma once

#include <span>
#include <string_view>

namespace symreal {

// A parameter in the declaration of a function, and as an argument of its call.
struct Passing {
  std::string_view declared = {}, passed = {};
};

// A type of integers: its names in C and in the language.
struct BridgeInteger {
  std::string_view c = {}, type = {};
  std::string_view to = {}, from = {}; // $value $type: of a number, and a number; empty: as others
};

struct BridgeSyntax {
  std::span<BridgeInteger const> integers = {};
  std::string_view to_integer = {}, from_integer = {};                     // $value $type
  Passing number = {}, integer = {}, input = {}, output = {}, object = {}; // $type, $value: of an integer, converted
  std::string_view copy = {}; // $from $from_last $from_next, before the call: of what is read and written
  // What a function returns: $type of an integer, $count of the numbers of a struct.
  std::string_view no_result = {}, number_result = {}, integer_result = {}, object_result = {};
  // The call, $made, and where what it returns goes: from the first result on.
  std::string_view no_store = {}, number_store = {}, object_store = {}; // an integer is a number then
  std::string_view object_local = {};                                   // $count: a variable of object_store
  std::string_view made = {}, made_without_result = {};   // $declared $passed $result; the latter, where it differs
  std::string_view structure = {}, import_structure = {}; // $count: a struct; its name, where a declaration needs it
  // The declarations of all functions: $structures $names and $declared of the parameters, $result; of those without
  // one, where they differ.
  std::string_view begin = {}, declaration = {}, declaration_without_result = {}, end = {};
  std::string_view bridge = {}; // $locals $copies $stored $argument_count $result_count
  std::string_view call = {};   // $arguments $array $first $next: the statement

  bool is_given() const { return !call.empty(); }
};

} // namespace symreal
