// Facts about the sources, collected by the Clang half in types free of Clang's: all decisions are made on these alone.
//
// A fact carries the real path and byte offsets of its text, so the same header met through two sources gives the same
// fact twice and the sets drop the second.
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/facts/tables.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::rewrite {

// Bytes [begin, end) of a file within the roots.
struct Span {
  std::string file;
  std::size_t begin = 0;
  std::size_t end = 0;
  auto operator<=>(Span const &) const = default;
};

// Reason for which a type stays as it is, if it does; texts in ledger.cpp.
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
  dropped_argument, // these never reach the parser
  macro_name,
};

// A token that spells a type: `double`, or the name of a library's typedef such as Vector3d. That of a `double` follows
// its neighbours until the syntax tree says more.
struct TypeToken {
  Fate fate = Fate::inactive;
  std::string replacement = {}; // of a converted one
  Passive why = not_passive;
  auto operator<=>(TypeToken const &) const = default;
};
using TypeTokens = std::map<Span, TypeToken>;

// Notes the fate of a token in one expansion or source.
void note(TypeTokens &types, Span const &span, TypeToken token);

struct Wrap {
  Span span;
  Use use;
  std::string detail; // the use's payload (uses.def)
  auto operator<=>(Wrap const &) const = default;
  // The payload for a reader that knows its kind.
  std::string const &payload(Payload kind) const {
    internal_check(info(use).payload == kind);
    return detail;
  }
};

// Kind of an annotated object's base, as far as the text of the annotation depends on it.
enum class Base { object, pointer, pointer_to_const, const_pointer_to_const, const_object };

struct ItemFact {
  std::string label;
  std::string expression;        // with symreal_i[k] for the index of section k
  std::string tested = {};       // the expression with run-time tests of its indices; empty: none is needed
  std::string base;              // the item without its sections
  std::vector<Section> sections; // none: the whole object
  Place place;
  bool is_return = false;
  bool base_is_name = false; // the base is one identifier
  bool section_on_base = false;
  // Set from the syntax tree:
  bool seen = false; // it stands at a statement position
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

// The function that a function pragma precedes.
struct FunctionFact {
  std::string name;
  Signature signature;
  Span brace;
  struct Value {
    std::string name;
    Place place;
  };
  std::vector<Value> values;      // its parameters by value that hold numbers, and its integer ones that it uses
  std::vector<Value> parameters;  // those by value that may lie on the stack of the caller
  std::vector<std::string> leads; // access paths to objects of the caller: pointers, also in objects
  bool is_template = false;       // an instantiation of it may have other numbers than REALs
};

struct PragmaFact {
  Span span;
  std::size_t continued_lines = 0;
  Place place;
  std::string display_file;
  bool is_function = false;
  std::optional<std::size_t> configured; // for a pragma from the request: the index of its kernel
  std::vector<ClauseFact> clauses;
  std::vector<FunctionFact> function;      // at most one
  std::vector<FunctionFact::Value> around; // locals of the function around the block that begins here
  std::vector<std::string> leads;          // those whose pointees may vary
  // Result variables of `loop(N)`, set once its loop is known to be boundable.
  std::optional<std::string> loop_targets; // (x)(y)
  bool tests_late = false;                 // after the body

  ClauseFact const *clause(Clause wanted) const {
    for (ClauseFact const &one : clauses)
      if (one.clause == wanted) return &one;
    return nullptr;
  }
  // Whether the pragma asks for a kernel rather than a way to record a statement or function.
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
  Place source; // the innermost place on its include path in a source rather than a header
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
// several headers, instantiations and expansions; the change is made only if all of them permit it.
struct DecisionFact {
  std::vector<Alteration> alterations; // empty: nothing to change there
  std::vector<Refusal> refusals;
  std::vector<Refusal> misuses; // places at which its macro prevents a select, if one is to be made
  std::vector<Refusal> uses;    // unobstructed uses: a refusal elsewhere applies to their macro, too
  std::optional<Span> needs;    // the decision that must change for this one to change
};

// A `double` or `float` that the file spells, compiled or not (spelled_types.h).
struct SpelledType {
  enum class Where { code, macro, directive };
  Span span;
  bool is_float = false;
  bool is_long = false;
  bool kept = false; // a comment on its line asks for that
  Where where = Where::code;
  std::string name = {};                // of the macro or directive
  std::vector<std::size_t> within = {}; // offsets of the directives that open the enclosing #if parts
};

struct FileFact {
  std::string display_path;
  std::string compiled_name; // as in __FILE__
  std::string text;
  std::vector<SpelledType> spelled = {};
  std::map<std::size_t, std::string> conditions = {}; // by the offset of a directive that opens a part of an #if
  std::vector<std::pair<std::size_t, std::size_t>> directives = {};
  std::vector<std::pair<std::size_t, std::size_t>> kept = {}; // lines with the comment `symreal: keep`
};

// The bases and fields of a class, and which of them hold REAL or an integer: a source with only a forward declaration
// of the class does not see what a pointer to it owns.
struct ClassFact {
  template <class Name> struct Constituent {
    Name name;
    bool holds;
  };
  std::string access;                        // of the members that follow the opening brace
  std::vector<Constituent<Span>> bases = {}; // as spelled
  std::vector<Constituent<std::string>> fields = {};
};

// A function that takes arguments through `...` or another's list, and the destinations of that list.
struct ListFact {
  // A destination outside the roots that does more than print the list.
  struct Outside {
    Place place;
    std::string function;
    bool leaves = false; // no value comes back
  };
  bool reads = false;                     // reads numbers, or passes the list to a callee that the source does not name
  bool prints = false;                    // by a function of the C library
  std::set<std::string> handed;           // to functions of the program, by qualified name; empty: to any
  std::map<std::string, Outside> outside; // by place
};

// Text that changes the arithmetic of a part of a source: an option in an attribute, or a pragma.
struct ArithmeticFact {
  std::string own;     // the option, or the pragma as an operator
  std::string instead; // empty for most pragmas
  std::size_t continued_lines = 0;
};

// A conversion of a REAL to an integer, to float or to long double.
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
  TypeTokens types;
  std::set<Wrap> wraps;
  std::set<Span> shared; // conversions whose text is compiled in several ways: each follows its context's type
  std::map<Span, ClassFact> members;                // by the opening brace of a class
  std::map<std::string, std::vector<bool>> reached; // by real path: the offsets of tokens that reached the parser
  std::set<Span> skipped;                           // parts of an #if that are not taken
  std::set<ConversionFact> conversions;
  std::set<Span> comparisons;            // of REALs, by the operator
  std::set<Span> printed;                // declarations whose text the program prints
  std::set<Span> quoted;                 // arguments that a macro stringifies or pastes: their text is data
  std::set<Span> pasted;                 // those of them that are pasted
  std::set<Span> text_calls;             // calls of macros that stringify an argument
  std::map<Span, PragmaFact> pragmas;    // by the span of the directive, or of the function's brace
  std::map<std::string, ListFact> lists; // by the qualified name of the function
  std::map<Span, ArithmeticFact> arithmetic;
  Choices choices;                   // of the sources that ask about types
  std::set<std::string> asking;      // their real paths
  std::vector<Kernel> by_hand;       // generate_code("...") in a hand-written symbolic main
  std::set<std::string> definitions; // mangled names of the functions that the sources define
  // Linker names of static variables that the program may change; a leading star marks an unchanged one that points to
  // what may change.
  std::set<std::string> changeable;
  std::set<std::string> exported;      // those that carry REAL and that other sources can use
  std::map<std::string, UseFact> uses; // by mangled name, the first use
  // Undefined symbols that each defined symbol needs, under an empty name those of the program's start; and for each
  // undefined symbol a word that the text of its definition contains.
  std::map<std::string, std::set<std::string>> links;
  std::map<std::string, std::string> linked_words;
  std::map<std::string, NamedStatement> names;  // by the place where they begin
  std::map<std::string, DecidingText> deciding; // by places and type
  std::map<Span, DecisionFact> decisions;       // by the token `if`, `?`, `for`, `while`, `do`, or the function's brace
  std::map<std::string, Note> externals;        // by mangled name: the place of the pragma, and the function's name
  std::set<std::size_t> configured_externals;   // indices of the request's externals that a source declares
  std::set<std::string> kernel_functions;       // qualified names of functions that a configured kernel may name
  std::map<std::string, Place> taken_names;     // names that the rewriter might generate, by first use in the sources
  std::vector<std::string> include_dirs;
  std::set<std::string> read; // real paths, without the system's headers
  std::vector<Diagnostic> diagnostics;
  bool broken = false;     // a source does not compile
  bool makes_text = false; // from REALs, where it could be read back
};

// Whether any of the sorted, disjoint spans overlaps this one.
bool meets(std::set<Span> const &spans, Span const &span);

std::string text_of(Span const &span, Facts const &facts);

Place place_in(FileFact const &file, std::size_t offset);

// Whether a macro around the expression would stand in an argument that becomes text. An expression may also hold the
// whole macro call.
bool is_quoted(Facts const &facts, Span const &expression);

// Entry of Facts::definitions for a name that both the program and the C library define; with a file, if it has
// internal linkage. A function or variable with external linkage is renamed in all sources if one defines it; else it
// is the library's.
std::string definition_of(std::string const &name, std::string const &file = {});

bool is_defined(Facts const &facts, Wrap const &own_name);

// A header that several sources include says the same each time.
void add_diagnostic(Facts &facts, Diagnostic const &diagnostic);

// Whether both list the same bases and fields. Their knowledge of these may differ.
bool same_members(ClassFact const &one, ClassFact const &other);

// Adds the facts of another source. The order of the sources matters only for facts about the same thing.
void merge(Facts &facts, Facts &&other);
void merge(Choices &choices, Choices &&others);

// Facts as bytes, to be kept from run to run, and back: nullopt if the bytes are not those of facts, as far as that can
// be detected.
std::string to_bytes(Facts facts);
std::optional<Facts> facts_of_bytes(std::string_view bytes);

// Parts of a request, only for comparing two of them.
std::string to_bytes(ConfiguredKernel kernel);
std::string to_bytes(ConfiguredExternal external);

// Facts as text (JSON with comments) and back, so that decisions on them can be tested without Clang. Throws
// std::invalid_argument with the error and its place.
//
// A struct is an object of its members; a member that has the value of a struct just made is left out. A map is a list
// of pairs, a use or clause its name, another enumeration its number, and flags by offset are the lengths of their
// runs, the first of those that do not hold.
std::string to_text(Facts facts);
Facts facts_of_text(std::string const &text);

} // namespace symreal::rewrite
