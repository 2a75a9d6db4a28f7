// What stands around the functions of a file: patterns, for languages whose files one printer writes (print/module.h).
//
// Names come in three cases: $a_name, $AName ($A_name of an object) and $A_NAME. Everywhere there are $module (the
// prefix, or the kernel), $base (the file without its ending), and what the interface calls its parts: $preprocess,
// $compute, $guard_text, $input_count, $parameter_count, $constant_count, $output_count, $guard_count; $inputs,
// $parameters, $constants, $outputs and $guards are the counts.
#pragma once

#include <span>
#include <string_view>

namespace symreal {

// A function or a constant that generated code names.
struct Helper {
  std::string_view name = {}, text = {};
  bool declares = false; // stands before what the module contains
};

struct StringSyntax {
  std::string_view quote = "\"";
  std::string_view escaped = "\"\\"; // a backslash stands before these
  bool doubles_quotes = false;       // a quotation mark is written twice, and nothing is escaped
  std::size_t most = 0;              // longer ones are joined
  std::string_view joint = {};
};

// The annotated objects of a role: input, parameter, output.
struct ObjectsSyntax {
  std::string_view begin = {}, end = {}; // $role $count
  // $name $first $last $next, all from the language's first index; $size, $extents (3, 4), $more_extents
  // (with a comma before the first), $extents_comma (with one behind a single extent), $reversed (4, 3),
  // $reversed_shape (in parentheses, if there are any), $type
  std::string_view object = {};
  std::string_view separator = {};
  std::string_view number = {}, array = {}; // $type: of a number; $element $extent
};

struct ModuleSyntax {
  std::size_t indent = 0;           // of tables, helpers and remarks
  bool is_named_after_file = false; // so the file's name must be one in the language
  std::string_view begin = {};
  std::string_view size = {};       // $name $value
  std::string_view index_list = {}; // $name $count $values: of a matrix of derivatives
  // Longer ones are made of parts, where a language bounds what stands in one: $name and $count of the list, and
  // $part, its name, $first, $last, from the language's first index, $values; behind them $parts, a list of names.
  std::size_t most_indices = 0;
  std::string_view long_index_list = {}, index_part = {}, joined_indices = {};
  ObjectsSyntax places = {}, structure = {};
  std::string_view functions = {};                                 // behind them
  std::string_view contains = {};                                  // between declarations and functions
  std::string_view guards_begin = {}, guard = {}, guards_end = {}; // $number $text, a literal
  std::string_view no_guards = {};                                 // in their place where there are none
  std::string_view end = {};
  // The main program: $input_values, $parameter_values, $all_values (of both) and $labels are lists; $call is one of
  // the two below.
  std::string_view main = {}, call = {}, checked_call = {};
};

} // namespace symreal
