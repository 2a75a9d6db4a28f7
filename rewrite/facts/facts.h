// What the Clang half collects about the sources, free of Clang's types: the decisions are made on these alone.
//
// A fact carries the real path and the byte offsets it is about, so the same header met through two sources gives the
// same fact twice and the sets drop the second.
#pragma once

#include "rewrite/facts/clause.h"
#include "rewrite/facts/result.h"
#include "rewrite/facts/use.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::rewrite {

// Bytes [begin, end) of a file within the roots.
struct Span {
  std::string file;
  std::size_t begin = 0;
  std::size_t end = 0;
  auto operator<=>(Span const &) const = default;
};

// Why a type that is compiled stays as it is, where it does. The words for each are in ledger.cpp.
enum Passive : unsigned char {
  not_passive,
  constant_variable,
  static_member,
  external_declaration,
  template_value,
  static_assertion,
  enumerator,
  constant_expression,
  array_bound,
  plain_template,
  long_double,
  complex_double,
};

// A token that spells a type: `double`, or the name of a library's typedef such as Vector3d.
struct TypeToken {
  Span span;
  std::string replacement; // empty: it stays, and is known to
  Passive why = not_passive;
  auto operator<=>(TypeToken const &) const = default;
};

struct Wrap {
  Span span;
  Use use;
  std::string detail; // the use's payload (uses.def)
  auto operator<=>(Wrap const &) const = default;
};

// What the base of an annotated object is, as far as the source of the annotation depends on it.
enum class Base { object, pointer, pointer_to_const, const_pointer_to_const, const_object };

struct ItemFact {
  std::string label;
  std::string expression;        // with symreal_i[k] where a section stood
  std::string tested = {};       // the expression with tests of the indices that the run knows; empty: none is needed
  std::string base;              // the item without its sections
  std::vector<Section> sections; // none: the whole object
  Place place;
  bool is_return = false;
  bool base_is_name = false; // the base is one identifier
  bool section_on_base = false;
  // From the syntax tree.
  bool seen = false; // it stands where a statement can
  bool carries_real = false;
  bool holds_scalar = false;
  std::string type;
  Base base_kind = Base::object;
  ObjectLayout layout;               // of each element
  std::vector<std::string> left_out; // its members that point to numbers
  std::vector<std::string> kept;     // its members with numbers that are not converted
};

struct ClauseFact {
  Clause clause = {};
  Place place;
  std::string argument; // range, generate, call: the text between the parentheses
  std::vector<ItemFact> items;
};

// The function that a function pragma stands before.
struct FunctionFact {
  std::string name;
  Signature signature;
  Span brace;
  struct Value {
    std::string name;
    Place place;
  };
  std::vector<Value> values;      // its parameters by value that hold numbers, and the integers among them that it uses
  std::vector<Value> parameters;  // those by value that may lie on the stack of the caller
  std::vector<std::string> leads; // what leads to objects of the caller: pointers, also in objects
};

struct PragmaFact {
  Span span;
  std::size_t continued_lines = 0;
  Place place;
  std::string display_file;
  bool is_function = false;
  std::optional<std::size_t> configured; // it stands in no file: which of the request's kernels it is
  std::vector<ClauseFact> clauses;
  std::vector<FunctionFact> function;      // at most one
  std::vector<FunctionFact::Value> around; // locals of the function around the block that begins here
  std::vector<std::string> leads;          // those among them that lead to other objects than always the same
  // Of `loop(N)`, once its loop is known to be one that can be bounded.
  std::optional<std::string> loop_targets; // (x)(y)
  bool tests_late = false;                 // after the body

  ClauseFact const *clause(Clause wanted) const {
    for (ClauseFact const &one : clauses)
      if (one.clause == wanted) return &one;
    return nullptr;
  }
  // Else it only says how a statement or function is recorded.
  bool is_kernel() const {
    for (ClauseFact const &one : clauses)
      if (!info(one.clause).has(trait::SETTING)) return true;
    return false;
  }
};

// A function that carries REAL, used from code that is compiled here, and not defined in the same source.
struct UseFact {
  std::string mangled;
  std::string name;
  std::size_t parameters = 0;
  Place declaration;
  Place place;
  Place source; // on the way to it, the last place in a source rather than a header
};

// One of the changes that make a select of a decision: `before` and `after` go around the characters, or `before`
// replaces them.
struct Alteration {
  Span span;
  std::string before;
  std::string after;
  bool replaces = false;
  bool inside = false; // of other macros around the same characters
  auto operator<=>(Alteration const &) const = default;
};

// A decision on REALs, or a function whose `return`s depend on one. The same source may be met several times, through
// several headers, instantiations and expansions; only if none of them refuses the change is made.
struct DecisionFact {
  std::vector<Alteration> alterations; // none: nothing to change there
  std::vector<Refusal> refusals;
  std::vector<Refusal> misuses; // where its macro stands in the way of a select, if one is to be made
  std::vector<Refusal> uses;    // where nothing is in the way: a refusal elsewhere is in theirs too
  std::optional<Span> needs;    // the decision without which this one cannot be changed
};

// A `double` or `float` that the file spells, compiled or not (spelled_types.h).
struct SpelledType {
  enum class Where { code, macro, directive };
  Span span;
  bool is_float = false;
  bool is_long = false;
  bool kept = false; // its line says so
  Where where = Where::code;
  std::string name = {};                // of the macro or directive
  std::vector<std::size_t> within = {}; // offsets of the directives that open the parts of #if around it
};

struct FileFact {
  std::string display_path;
  std::string compiled_name; // as __FILE__ has it
  std::string text;
  std::vector<SpelledType> spelled = {};
  std::map<std::size_t, std::string> conditions = {}; // by the offset of a directive that opens a part of an #if
  std::vector<std::pair<std::size_t, std::size_t>> directives = {};
  std::vector<std::pair<std::size_t, std::size_t>> kept = {}; // lines with the comment `symreal: keep`
};

// What the preprocessor does to a token so that it never reaches the parser.
enum class Consumed { dropped_argument, macro_name };

// The bases and fields of a class, and which of them hold REAL or an integer: a source that knows a class only by its
// name does not see what a pointer to it owns.
struct ClassFact {
  template <class Name> struct Part {
    Name name;
    bool holds;
  };
  std::string access;                 // of the members that follow the opening brace
  std::vector<Part<Span>> bases = {}; // as they are written
  std::vector<Part<std::string>> fields = {};
};

// A function that takes arguments through `...`, or the list of another's: where what it is given goes.
struct ListFact {
  // Outside the roots, and to what does not only write it as text.
  struct Outside {
    Place place;
    std::string function;
    bool leaves = false; // nothing comes back from there
  };
  bool reads = false;                     // numbers, or it hands the list on where the source does not say to whom
  bool prints = false;                    // by a function of the C library
  std::set<std::string> handed;           // to functions of the program, by qualified name; empty: to any
  std::map<std::string, Outside> outside; // by place
};

// Text that changes the arithmetic of a part of a source: an option in an attribute, or a pragma.
struct ArithmeticFact {
  std::string own;     // the option, or the pragma as an operator
  std::string instead; // nothing for most pragmas
  std::size_t continued_lines = 0;
};

// Of a REAL to an integer, to float or to long double.
struct ConversionFact {
  Span span;
  std::string type;
  bool to_integer;
  auto operator<=>(ConversionFact const &) const = default;
};

// An answer of the language about types, at one place of a function.
struct Choice {
  Place place;
  std::string what;
  std::set<std::string> results; // of all instantiations there
};
using Choices = std::map<std::string, Choice>;

struct Facts {
  std::map<std::string, FileFact> files; // by real path
  std::set<TypeToken> types;
  std::set<Span> doubles; // every `double` that reached the parser, understood or not
  std::set<Wrap> wraps;
  std::set<Span> shared; // conversions whose text is compiled in several ways: each goes by what its context expects
  std::map<Span, ClassFact> members;                // by the opening brace of a class
  std::map<std::string, std::vector<bool>> reached; // by real path: the offsets of tokens that reached the parser
  std::set<Span> skipped;                           // parts of an #if that are not taken
  std::map<Span, Consumed> consumed;                // tokens that may not have reached the parser
  std::set<ConversionFact> conversions;
  std::set<Span> comparisons;            // of REALs, by the operator
  std::set<Span> printed;                // declarations whose text the program prints
  std::set<Span> quoted;                 // arguments that a macro stringifies or pastes: their text is data
  std::set<Span> pasted;                 // those of them that a macro pastes
  std::set<Span> text_calls;             // calls of macros that stringify an argument
  std::map<Span, PragmaFact> pragmas;    // by the span of the directive, or of the function's brace
  std::map<std::string, ListFact> lists; // by the qualified name of the function
  std::map<Span, ArithmeticFact> arithmetic;
  Choices choices;                   // of the sources that ask about types
  std::set<std::string> asking;      // their real paths
  std::vector<Kernel> by_hand;       // generate_code("...") in a symbolic main that was written by hand
  std::set<std::string> definitions; // mangled names of the functions that the sources define
  // Static variables that the program may change, as the linker knows them; behind a star, one that is not changed
  // itself and leads to what may be.
  std::set<std::string> changeable;
  std::set<std::string> exported;      // those that carry REAL and that other sources can use
  std::map<std::string, UseFact> uses; // by mangled name, the first use
  // By symbol that the source defines, with an empty one for what runs at the program's start: the symbols that it
  // needs and that the source does not define. And for each of these a word that the text of a definition has.
  std::map<std::string, std::set<std::string>> links;
  std::map<std::string, std::string> linked_words;
  std::map<std::string, NamedStatement> names;  // by the place where they begin
  std::map<std::string, DecidingText> deciding; // by places and type
  std::map<Span, DecisionFact> decisions;       // by the token `if`, `?`, `for`, `while`, `do`, or the function's brace
  std::map<std::string, Note> externals;        // by mangled name: where the pragma says so, and the function's name
  std::set<std::size_t> configured_externals;   // those of the request that a source declares
  std::set<std::string> kernel_functions;       // qualified names of what a configured kernel may name
  std::map<std::string, Place> taken_names;     // that the rewriter might write, by first use in the sources
  std::vector<std::string> include_dirs;
  std::set<std::string> read; // real paths, those of the system's headers left out
  std::vector<Diagnostic> diagnostics;
  bool broken = false;     // a source does not compile
  bool makes_text = false; // of REALs, where it could be read back
};

} // namespace symreal::rewrite
