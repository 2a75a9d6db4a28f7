// Language table: all that emitters know of a language. One walk over the schedule (emit/print) prints all of them.
//
// Strings with a '$' are patterns (pattern.h); the comment after each lists its placeholders. In patterns of
// expressions $x, $y, $z are operands, and $x:13 is one that needs parentheses unless it binds at least that tightly;
// binding strengths are those of the table of operations, C's.
//
// All patterns, including spellings and helpers, also have $real, the name of the real type, $suffix, the suffix of a
// number without an exponent, and the language's own words.
//
// Patterns of modules and bridges have names in three cases: $a_name, $AName and $A_NAME. They all have $module (the
// prefix, or the kernel), $base (the file name without extension), the interface names $preprocess, $compute,
// $guard_text, $input_count, $parameter_count, $constant_count, $output_count, $guard_count, and the counts $inputs,
// $parameters, $constants, $outputs and $guards.
#pragma once

#include "engine/emit/language/pattern.h"
#include "engine/graph/graph.h"
#include "engine/graph/names.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct Emission; // print/emission.h
// A part of a generated file that a language prints itself; ends in a newline, unless it is empty.
using Part = std::string (*)(Emission const &);

// Literals that read back to the same bits.
struct NumberSyntax {
  std::string_view nan = {}, negative_nan = {}, infinity = {}, negative_infinity = {};
  std::string_view exponent = "e";       // between mantissa and exponent
  std::string_view suffix = {};          // of numbers without an exponent
  std::string_view negative_zero = {};   // if it differs from -0.0
  std::string_view exponent_suffix = {}; // of numbers with an exponent
  int sign_binding = 14;                 // binding strength of a signed number
};

// Type of a variable: a number, a truth value, or a 64-bit integer.
struct TypeSyntax {
  std::string_view name = {}, zero = {};
};

// Differences of single precision from double. An empty type: unsupported.
struct SingleSyntax {
  TypeSyntax number = {};
  NumberSyntax numbers = {};
  std::string_view call_suffix = {}; // of math library names: "f"
  std::string_view narrowed = {};    // before a call, if functions return doubles: "(float)"
  std::span<Op const> given = {};    // operations whose functions return their argument type
};

// A placeholder of this language's patterns, with its text in double and single precision.
struct Word {
  std::string_view name = {}, in_double = {}, in_single = {};
};

// Exception to the spelling in the operation table. Precedence 0: never in parentheses.
struct OperationSpelling {
  Op op;
  std::string_view pattern = {}; // "merge($y, $z, $x)"
  int precedence = 0;
};

// Comment delimiters: `open` begins a comment, `next` its further lines; an empty `close`: it ends with the line.
struct CommentSyntax {
  std::string_view open = {}, next = {}, close = {};
};

// Line layout. Lines are broken at blanks. Functions are indented by `base`, each block by `step` more.
struct LineLimits {
  std::size_t width = 100;
  std::size_t least = 0;              // least width of the text at deep indentation, even beyond `width`
  std::string_view continuation = {}; // suffix of a line that continues on the next
  std::size_t base = 0, step = 2;
};

struct StringSyntax {
  std::string_view quote = "\"";
  std::string_view escaped = "\"\\"; // characters that need a backslash
  bool doubles_quotes = false;       // quotation marks are doubled, and other characters stay
  std::size_t most = 0;              // longer literals are joined
  std::string_view joint = {};
};

struct ExpressionSyntax {
  std::string_view call_prefix = {}; // of math library names: "std::"
  std::string_view call_open = "(", call_close = ")";
  std::string_view local_prefix = {};                      // of operations that are functions of this file
  std::string (*variable)(std::string const &) = nullptr;  // converts the name of a variable
  std::span<OperationSpelling const> operations = {};      // exceptions to the operation table
  std::string_view element = {};                           // $array $index
  std::size_t first_index = 0;                             // of an array
  std::string_view yes = {};                               // a condition that is always true
  bool has_plus = false;                                   // as a prefix; parentheses replace it elsewhere
  std::string_view truth_as_number = {};                   // $x; empty: truth values are numbers
  std::string_view small_integer = {}, large_integer = {}; // $value $signed $hex: of 31 bits, of 64 bits
  std::string_view kept_integer = {}; // $element of an array of numbers that holds an integer's bits
  std::string_view hidden = {};       // $x, whose constant value compilers must not see
  std::string_view table_index = {};  // $index $extent: clamped to 0..extent-1
};

struct StatementSyntax {
  std::string_view first_declaration = {};      // $type $name, if declarations must precede all statements
  std::string_view variable = {};               // $type $name $value: declares a variable that is assigned again
  std::string_view constant = {};               // $type $name $value: declares a constant
  std::string_view set = {};                    // $name $value
  std::string_view keep_integer = {};           // $element $value
  std::string_view array = {}, zero_array = {}; // $name $count: of numbers
  std::string_view open = {}, otherwise = {},
                   close = {};       // $condition: a block, its else, its end; empty: omits the line
  std::string_view check = {};       // $condition $number: returns the number of a guard
  std::string_view value_check = {}; // $name $text: reports a value that is not finite
  std::string_view value_check_begin = {};
};

struct FunctionSyntax {
  // $result $name $parameters $target $pure $apart $beside: head of an interface function, of a local one; the end
  std::string_view head = {}, local_head = {}, end = {};
  std::string_view pure = {};                   // in heads of functions that call only functions of the file
  std::string_view apart = {};                  // in heads of parts that compilers must not inline
  std::string_view beside = {};                 // in heads of parts whose loops are vectorised
  std::string_view no_result = {}, status = {}; // $result
  // $target: the array that a function fills. $name: an array parameter; an empty `output`: the function returns the
  // array
  std::string_view input = {}, output = {}, local_output = {}; // local: in this file's functions; empty: as `output`
  bool output_first = false;                                   // among the parameters
  std::string_view input_declaration = {}, output_declaration = {}; // $name: if the body declares types
  // $names of all variables and of the returned array, if one statement declares them; the latter for none
  std::string_view locals = {}, no_locals = {};
  std::string_view unused = {};                    // $name of an unused parameter
  std::string_view results = {};                   // $name $count: before the results are stored
  std::string_view success = {};                   // the end of a function with guards
  std::string_view finish = {}, local_finish = {}; // $name: the last statement of every function
  std::string_view failed = {};                    // declares the variable for a status
  std::string_view status_declaration = {};        // of the parameter for a status, if it is one
  std::string_view call = {},
                   checked_call = {}; // $name $group $arguments: calls a part of this function; checked: returns status
  bool parts_store = false;           // parts may take the output array
  std::size_t most_statements = 500;  // longer bodies are cut: compilers take superlinear time on one function
  // Class around a group of parts, $name, if the language limits the functions of a class.
  std::string_view group_begin = {}, group_end = {};
  std::size_t group_size = 0;
};

// Threads that share the parts of a function: lines around a stage, and around the calls of each part.
struct ParallelSyntax {
  std::string_view stage_begin = {}, part_begin = {}, part_end = {}, stage_end = {}; // $threads
  std::size_t indent = 0;                                                            // of the calls

  bool is_given() const { return !stage_begin.empty(); }
};

// Loops that --reroll finds, and the tables that they read: constants of the function.
struct LoopSyntax {
  std::string_view begin = {}, end = {};               // $index $count
  std::string_view counter = {}, count = {};           // $index: counts all iterations of a nest, from 0; its increment
  std::string_view row = {}, stored_row = {};          // $name $table $index: begin of a row that is read, stored
  std::string_view element_table = {}, table_end = {}; // $name $count: of array indices
  // $rows $copy: a statement for each row and column below a diagonal, by columns, in blocks of eight
  std::string_view below_diagonal = {};

  bool is_given() const { return !begin.empty(); }
};

// Vectors of $width numbers for --vector. Operators apply lane by lane, also to a vector and a number.
struct VectorSyntax {
  std::string_view begin = {}, otherwise = {}, end = {}; // lines around vector code and scalar code
  std::string_view type = {};
  std::string_view load = {}, store = {}; // $place; $value
  std::string_view build = {};            // $values
  std::string_view shuffle = {};          // $x $y $lanes
  std::string_view lane = {};             // $name $lane

  bool is_given() const { return !begin.empty(); }
};

// Vectorised sines and cosines at the start of compute, in mode fast: $angles, $sine and $cosine are arrays, `helper`
// prints the function that `call` calls.
struct AnglesSyntax {
  std::string_view call = {};            // $count $angles $sine $cosine
  std::string_view from = {};            // $array $first: the subarray from that element on
  std::string_view begin = {}, end = {}; // $name $count: around the elements of a constant array
  Part helper = nullptr;

  bool is_given() const { return helper; }
};

// A table of constants: `begin`, lines of numbers, `end`.
struct TableSyntax {
  std::string_view begin = {}, end = {}; // $name $count
  std::string_view index_helper = {};    // function that table_index calls
  // Longer tables are joined from parts, if the language limits their length: $name $parts, a list of names.
  std::size_t most_values = 0;
  std::string_view joined = {};
};

// A parameter in a function's declaration, and as an argument of its call.
struct Passing {
  std::string_view declared = {}, passed = {};
};

// An integer type: its names in C and in the language.
struct BridgeInteger {
  std::string_view c = {}, type = {};
  std::string_view to = {}, from = {}; // $value $type: converts from and to a number; empty: the default
};

// Bridges: local functions by which a language calls external functions. A bridge takes the arguments as one array and
// stores the results in another. C needs no bridges.
//
// In patterns $name is the bridge, $c_name the function; a parameter is $p (p0, p1, ...), of $count numbers, at $at ..
// $last of the arguments, or of the results if it is written ($next: the index after them).
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

// A call of an external function: an expression per argument; results go to the elements of `array` from `first` on.
struct ExternalCall {
  External const &function;
  std::string label; // in the names of local variables
  std::vector<std::string> arguments;
  std::string array;
  std::size_t first = 0;
  bool is_wanted = true; // the returned value is read
};

// Calls of external functions: direct, or by bridges; both empty if the language has neither.
struct ExternalSyntax {
  Part declarations = nullptr;
  std::vector<std::string> (*call)(ExternalCall const &) = nullptr; // the statements
  BridgeSyntax bridge = {};

  bool is_given() const { return call || bridge.is_given(); }
};

// An extra file beside the source.
struct Companion {
  std::string_view suffix = {}; // ".h"
  Part text = nullptr;
  std::string_view option = {};     // "mainline": written on this request; empty: always written
  bool is_named_after_file = false; // its name must be an identifier
  bool takes_doubles = false;       // the functions must take doubles
};

// A helper: a function or a constant that generated code names.
struct Helper {
  std::string_view name = {}, text = {};
  bool declares = false; // precedes the contents of the module
};

// A source file: banner, begin, declarations of external functions, open, tables, integer functions, hide helper,
// functions, end.
struct FileSyntax {
  std::string_view extension = {}; // ".c"
  std::string_view kept_when = {}; // $pow: end of the promise of modes strict and finite
  std::string_view pow_flag = {};  // $pow for a kernel with powers
  std::string_view fast_when = {}; // end of the promise of mode fast
  Part whole = nullptr;            // prints the whole file, without statements
  Part begin = nullptr, open = nullptr;
  Part integer_functions = nullptr; // those that the functions call; empty if unused
  std::string_view hide_helper = {};
  std::span<Helper const> helpers = {}; // written if the printed text names them
  Part end = nullptr;
  std::span<Companion const> companions = {};
};

// The annotated objects of a role: input, parameter, output.
struct ObjectsSyntax {
  std::string_view begin = {}, end = {}; // $role $count
  // $name $first, from the language's first index on; $extents (3, 4), $more_extents (with a leading comma),
  // $extents_comma (with a comma after a single extent), $reversed_shape (in reverse and in parentheses, if not empty),
  // $type
  std::string_view object = {};
  std::string_view separator = {};
  std::string_view number = {}, array = {}; // $type: of a number; $element $extent
};

// The code around the functions, for languages whose files print/module.h prints.
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

struct Language {
  std::string_view name = {}, doc = {}; // its row in languages.def
  NameRules names;
  bool has_namespace = false; // whether the prefix is a namespace; else it is prepended to function names
  CommentSyntax comment;
  LineLimits lines;
  NumberSyntax numbers;
  TypeSyntax number, truth, wide;
  SingleSyntax single;
  std::span<Word const> words = {};
  bool is_single = false; // whether numbers are those of `single`
  ExpressionSyntax expressions;
  StatementSyntax statements;
  FunctionSyntax functions;
  ParallelSyntax parallel;
  LoopSyntax loops;
  VectorSyntax vectors;
  AnglesSyntax angles;
  TableSyntax tables;
  ExternalSyntax externals;
  FileSyntax files;
  ModuleSyntax module;
  StringSyntax strings;
  std::span<Op const> lacks = {}; // operations that it cannot compute
  bool has_blocks = true;         // false: both arms of a select are computed
};

// The language with numbers of single precision, which it must support.
Language in_single_precision(Language language);

// Values of the placeholders that all patterns of the language have.
std::vector<std::pair<std::string_view, std::string_view>> words_of(Language const &language);
// A pattern filled with these words and its own values; or with the words alone, leaving other placeholders.
std::string fill(Language const &language, std::string_view pattern,
                 std::initializer_list<std::pair<std::string_view, std::string_view>> values);
std::string with_words(Language const &language, std::string_view pattern);

// A literal of the number; in single precision of the nearest float.
std::string constant(Language const &language, double value);

// Lines as one comment, without a final newline. `closed_apart`: whether the closing mark has a line of its own.
std::string comment(Language const &language, std::vector<std::string> const &lines, bool closed_apart = false);

// Text as a one-line string literal, except for the joints of a long one.
std::string literal(Language const &language, std::string_view text);

// Element such as "a[3]"; `index` counts from 0.
std::string element(Language const &language, std::string_view array, std::size_t index);

} // namespace symreal
