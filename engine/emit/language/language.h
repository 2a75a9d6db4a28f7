// A language: all that emitters know of it. One walk over the plan (emit/print) prints all of them. The fields, and
// the places of those that are patterns (pattern.h), stand in fields.def, from which a language's file is read as well
// (language_file.h).
#pragma once

#include "engine/emit/language/pattern.h"
#include "engine/graph/graph.h"
#include "engine/graph/names.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct Emission; // print/emission.h
// A part of a generated file that a language prints itself; ends in a newline, unless it is empty.
using Part = std::string (*)(Emission const &);
struct ExternalCall;
using WriteCall = std::vector<std::string> (*)(ExternalCall const &);
using WriteVariable = std::string (*)(std::string const &);

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

// An integer type: its names in C and in the language.
struct BridgeInteger {
  std::string_view c = {}, type = {};
  std::string_view to = {}, from = {}; // $value $type: converts from and to a number; empty: the default
};

// A helper: a function or a constant that generated code names.
struct Helper {
  std::string_view name = {}, text = {};
  bool declares = false; // precedes the contents of the module
};

#define SYNTAX(type) struct type {
#define TEXT(name, value) std::string_view name = value;
#define PATTERN(name, places) std::string_view name = {};
#define FIELD(type, name, value) type name = value;
#define MEMBER(type, name, value) type name = value;
#define IS_GIVEN(condition)                                                                                            \
  bool is_given() const { return condition; }
#define END(type)                                                                                                      \
  }                                                                                                                    \
  ;
#include "engine/emit/language/fields.def"

// A call of an external function: an expression per argument; results go to the elements of `array` from `first` on.
struct ExternalCall {
  External const &function;
  std::string label; // in the names of local variables
  std::vector<std::string> arguments;
  std::string array;
  std::size_t first = 0;
  bool is_wanted = true; // the returned value is read
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
