// Module syntax: patterns of the code around functions, for languages whose files print/module.h prints.
//
// Names have three cases: $a_name, $AName ($A_name of an object) and $A_NAME. All patterns have $module (the prefix, or
// the kernel), $base (the file name without extension), the interface names $preprocess, $compute, $guard_text,
// $input_count, $parameter_count, $constant_count, $output_count, $guard_count, and the counts $inputs, $parameters,
// $constants, $outputs and $guards.
#pragma once

#include <span>
#include <string_view>

namespace symreal {

// A helper: a function or a constant that generated code names.
struct Helper {
  std::string_view name = {}, text = {};
  bool declares = false; // precedes the contents of the module
};

struct StringSyntax {
  std::string_view quote = "\"";
  std::string_view escaped = "\"\\"; // characters that need a backslash
  bool doubles_quotes = false;       // quotation marks are doubled, and other characters stay
  std::size_t most = 0;              // longer literals are joined
  std::string_view joint = {};
};

// The annotated objects of a role: input, parameter, output.
struct ObjectsSyntax {
  std::string_view begin = {}, end = {}; // $role $count
  // $name $first $last $next, from the language's first index on; $size, $extents (3, 4), $more_extents (with a leading
  // comma), $extents_comma (with a comma after a single extent), $reversed (4, 3), $reversed_shape (in parentheses, if
  // not empty), $type
  std::string_view object = {};
  std::string_view separator = {};
  std::string_view number = {}, array = {}; // $type: of a number; $element $extent
};

struct ModuleSyntax {
  std::size_t indent = 0;           // of tables, helpers and remarks
  bool is_named_after_file = false; // the file's name must be an identifier
  std::string_view begin = {};
  std::string_view size = {};       // $name $value
  std::string_view index_list = {}; // $name $count $values: of a matrix of derivatives
  // Longer lists are joined from parts, if the language limits their length: $name and $count of the list, and $part,
  // its name, $first, $last, from the language's first index on, $values; then $parts, a list of names.
  std::size_t most_indices = 0;
  std::string_view long_index_list = {}, index_part = {}, joined_indices = {};
  ObjectsSyntax places = {}, structure = {};
  std::string_view functions = {};                                 // code after the functions
  std::string_view contains = {};                                  // between declarations and functions
  std::string_view guards_begin = {}, guard = {}, guards_end = {}; // $number $text, a literal
  std::string_view no_guards = {};                                 // replaces them if there are no guards
  std::string_view end = {};
  // The main program: $input_values, $parameter_values, $all_values (of both) and $labels are lists; $call is one of
  // the two patterns below.
  std::string_view main = {}, call = {}, checked_call = {};
};

} // namespace symreal
