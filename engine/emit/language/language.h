// What a language is to the emitters: a table. One walk over the schedule (emit/print) prints every language by it.
//
// Strings with a '$' are patterns (pattern.h); the comment behind each says which places it has. In patterns of
// expressions $x, $y, $z are operands, and $x:13 one that needs parentheses unless it binds at least that tightly;
// binding strengths are those of the table of operations, C's.
//
// Every pattern, spellings and helpers too, also has $real, the name of the type of numbers, $suffix, what stands
// behind a number without an exponent, and the language's own words.
#pragma once

#include "engine/emit/language/bridge.h"
#include "engine/emit/language/module.h"
#include "engine/emit/language/numbers.h"
#include "engine/emit/language/pattern.h"
#include "engine/graph/graph.h"
#include "engine/graph/names.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct Emission; // print/emission.h
// A part of a generated file that a language writes by itself; ends in a newline, unless it is empty.
using Part = std::string (*)(Emission const &);

// Where an operation is spelled otherwise than the table of operations says. Precedence 0: never in parentheses.
struct OperationSpelling {
  Op op;
  std::string_view pattern = {}; // "merge($y, $z, $x)"
  int precedence = 0;
};

// A comment begins with `open`; each further line of it with `next`; `close` is empty where it ends with the line.
struct CommentSyntax {
  std::string_view open = {}, next = {}, close = {};
};

// Lines are broken at blanks. Functions are indented by `base`, and what stands in a block by `step` more.
struct LineLimits {
  std::size_t width = 100;
  std::size_t least = 0;              // so much is kept for the text however deep it is indented, beyond the width
  std::string_view continuation = {}; // what ends a line that goes on in the next
  std::size_t base = 0, step = 2;
};

struct ExpressionSyntax {
  std::string_view call_prefix = {}; // of the names of the mathematical library: "std::"
  std::string_view call_open = "(", call_close = ")";
  std::string_view local_prefix = {}; // of the names of the operations that are functions of this file
  std::string (*variable)(std::string const &) = nullptr;  // how the name of a variable is written
  std::span<OperationSpelling const> operations = {};      // the exceptions to the table of operations
  std::string_view element = {};                           // $array $index
  std::size_t first_index = 0;                             // of an array
  std::string_view yes = {};                               // a condition that always holds
  std::string_view truth_as_number = {};                   // $x; empty: a truth value is a number
  std::string_view small_integer = {}, large_integer = {}; // $value $signed $hex: of 31 bits, of 64
  std::string_view kept_integer = {};                      // $element of an array of numbers that has an integer's bits
  std::string_view hidden = {};                            // $x, of which compilers must not know that it is constant
  std::string_view table_index = {};                       // $index $extent: the nearest within 0..extent-1
};

struct StatementSyntax {
  std::string_view first_declaration = {};      // $type $name, where all declarations stand before the first statement
  std::string_view variable = {};               // $type $name $value: a declaration of what is set again
  std::string_view constant = {};               // $type $name $value: a declaration of what is not
  std::string_view set = {};                    // $name $value
  std::string_view keep_integer = {};           // $element $value
  std::string_view array = {}, zero_array = {}; // $name $count: of numbers
  std::string_view open = {}, otherwise = {},
                   close = {};       // $condition: a block, its else, its end; an empty one is no line
  std::string_view check = {};       // $condition $number: returns the number of a guard
  std::string_view value_check = {}; // $name $text: reports a value that is not finite
  std::string_view value_check_begin = {};
};

struct FunctionSyntax {
  // $result $name $parameters $target $pure $apart $beside: of the interface, of this file; behind the last
  std::string_view head = {}, local_head = {}, end = {};
  std::string_view pure = {};                   // in heads, of functions that call nothing outside of the file
  std::string_view apart = {};                  // in heads of parts, which compilers must not join again
  std::string_view beside = {};                 // of parts whose loops become vectors
  std::string_view no_result = {}, status = {}; // $result
  // $target: the array that a function fills. $name: a parameter that is an array of numbers; no output: the function
  // returns the array
  std::string_view input = {}, output = {}, local_output = {};      // local: of this file's functions; empty: as output
  bool output_first = false;                                        // among the parameters
  std::string_view input_declaration = {}, output_declaration = {}; // $name: where the types stand in the body
  // $names of all variables and of the array that is returned, where one statement declares them; without any
  std::string_view locals = {}, no_locals = {};
  std::string_view unused = {};                    // $name of a parameter that the body does not use
  std::string_view results = {};                   // $name $count: before the results are stored
  std::string_view success = {};                   // the end of a function with guards
  std::string_view finish = {}, local_finish = {}; // $name: the last statement of every function
  std::string_view failed = {};                    // declares what takes a status
  std::string_view status_declaration = {};        // of the parameter that does, where it is one
  std::string_view call = {},
                   checked_call = {}; // $name $group $arguments: of a part of this function; checked: return its status
  bool parts_store = false;           // a part of a function may be given the array that it fills
  std::size_t most_statements = 500;  // longer ones are cut: compilers take more than linear time on one function
  // Where a class may have only so many functions: $name of the class around these parts.
  std::string_view group_begin = {}, group_end = {};
  std::size_t group_size = 0;
};

// How threads share the parts of a function: lines around a stage and around the calls of each of its parts.
struct ParallelSyntax {
  std::string_view stage_begin = {}, part_begin = {}, part_end = {}, stage_end = {}; // $threads
  std::size_t indent = 0;                                                            // of the calls

  bool is_given() const { return !stage_begin.empty(); }
};

// Loops that --reroll makes of repeats, and the tables that they read: constants of the function.
struct LoopSyntax {
  std::string_view begin = {}, end = {};               // $index $count
  std::string_view counter = {}, count = {};           // $index: of the turns of two loops together, from 0; one more
  std::string_view row = {}, stored_row = {};          // $name $table $index: where a row begins that is read, stored
  std::string_view element_table = {}, table_end = {}; // $name $count: of elements of arrays
  // $rows $copy: a statement for each row and column below a diagonal, column by column, eight columns at a time
  std::string_view below_diagonal = {};

  bool is_given() const { return !begin.empty(); }
};

// Vectors of $width numbers that --vector computes with. Operators work on them lane by lane, and on a vector and a
// number.
struct VectorSyntax {
  std::string_view begin = {}, otherwise = {}, end = {}; // lines around a function with vectors and one without
  std::string_view type = {};
  std::string_view load = {}, store = {}; // $place; $value
  std::string_view build = {};            // $values
  std::string_view shuffle = {};          // $x $y $lanes
  std::string_view lane = {};             // $name $lane

  bool is_given() const { return !begin.empty(); }
};

// Sines and cosines side by side, which mode fast begins compute with: $angles, $sine and $cosine are arrays, `helper`
// is the function that `call` calls.
struct AnglesSyntax {
  std::string_view call = {};            // $count $angles $sine $cosine
  std::string_view from = {};            // $array $first: the array from that element on
  std::string_view begin = {}, end = {}; // $name $count: around the elements of an array of constants
  Part helper = nullptr;

  bool is_given() const { return helper; }
};

// A table of constants: `begin`, lines of numbers, `end`.
struct TableSyntax {
  std::string_view begin = {}, end = {}; // $name $count
  std::string_view index_helper = {};    // the function that table_index calls
  // Longer ones are made of parts, where a language bounds what stands in one: $name $parts, a list of names.
  std::size_t most_values = 0;
  std::string_view joined = {};
};

// A call of an external function: with an expression for each argument, its results go to the elements of an array of
// numbers from `first` on.
struct ExternalCall {
  External const &function;
  std::string label; // in the names of local variables
  std::vector<std::string> arguments;
  std::string array;
  std::size_t first = 0;
  bool is_wanted = true; // somebody reads the returned value
};

// How external functions are called: directly, or by bridges; nothing where the language cannot.
struct ExternalSyntax {
  Part declarations = nullptr;
  std::vector<std::string> (*call)(ExternalCall const &) = nullptr; // the statements
  BridgeSyntax bridge = {};

  bool is_given() const { return call || bridge.is_given(); }
};

// A file beside the source.
struct Companion {
  std::string_view suffix = {}; // ".h"
  Part text = nullptr;
  std::string_view option = {};     // "mainline": written where this is asked for, otherwise always
  bool is_named_after_file = false; // so the file's name must be one in the language
  bool takes_doubles = false;       // so the functions must, too
};

// Source: banner, begin, declarations of external functions, open, tables, integer functions, the helper that hides,
// functions, end.
struct FileSyntax {
  std::string_view extension = {}; // ".c"
  std::string_view kept_when = {}; // $pow: ends the promise of the modes strict and finite
  std::string_view pow_flag = {};  // $pow, of a kernel with powers
  std::string_view fast_when = {}; // ends that of mode fast
  Part whole = nullptr;            // all of it: functions are not printed as statements
  Part begin = nullptr, open = nullptr;
  Part integer_functions = nullptr; // those that the functions call; nothing where there are no such integers
  std::string_view hide_helper = {};
  std::span<Helper const> helpers = {}; // each is written where something that is printed names it
  Part end = nullptr;
  std::span<Companion const> companions = {};
};

struct Language {
  std::string_view name = {}, doc = {}; // its row in languages.def
  NameRules names;
  bool has_namespace = false; // the prefix names one; otherwise it begins the names of functions
  CommentSyntax comment;
  LineLimits lines;
  NumberSyntax numbers;
  TypeSyntax number, truth, wide;
  SingleSyntax single;
  std::span<Word const> words = {};
  bool is_single = false; // numbers are those of `single`
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
  std::span<Op const> lacks = {}; // what it cannot compute
  bool has_blocks = true;         // otherwise both arms of a select are computed
};

// The language with numbers of single precision, which it must have.
Language in_single_precision(Language language);

// What stands at the places that all patterns of the language have.
std::vector<std::pair<std::string_view, std::string_view>> words_of(Language const &language);
// A pattern with these and its own places filled; or with these alone, and the others left as they are.
std::string fill(Language const &language, std::string_view pattern,
                 std::initializer_list<std::pair<std::string_view, std::string_view>> values);
std::string with_words(Language const &language, std::string_view pattern);

// A number in the language; in single precision the nearest one there.
std::string constant(Language const &language, double value);

// Lines as one comment, without a newline behind it. `closed_apart`: what closes it stands on a line of its own.
std::string comment(Language const &language, std::vector<std::string> const &lines, bool closed_apart = false);

// Text as a literal in one line, but for the joints of a long one.
std::string literal(Language const &language, std::string_view text);

// "a[3]", counted from 0 here.
std::string element(Language const &language, std::string_view array, std::size_t index);

} // namespace symreal
