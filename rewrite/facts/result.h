// Result of the rewriter: the rewritten files, and facts about the program that they make.
#pragma once

#include "rewrite/facts/tables.h"
#include "rewrite/request/request.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace symreal::rewrite {

// A replacement on the original bytes of a file. Its length is never zero: an insertion includes the neighbouring
// character, so that its place is unambiguous even when two sources ask for it.
struct Edit {
  std::size_t offset;
  std::size_t length;
  std::string text;
  auto operator<=>(Edit const &) const = default;
};

// Fate of a `double` that a file spells. If expansions of a macro, or sources, differ, the last of these holds.
enum class Fate {
  inactive,  // not compiled in this configuration
  follows,   // converted like its neighbours: the syntax tree does not show it
  passive,   // compiled, and stays
  diagnosed, // compiled, and an error says why it cannot be converted
  converted, // to REAL
};

// One entry of the ledger: there is one for each `double` and `float` in the files of the roots.
struct Spelling {
  Place place;
  std::string type; // double, long double or float
  Fate fate;
  std::string reason;
  std::string detail = {}; // of the reason: a macro's name, a directive
};

// A file within the roots that at least one source includes, changed or not.
struct File {
  std::string path;         // real path
  std::string display_path; // spelled by the user or the including file
  std::string original;
  std::string text; // the original with its edits; it has as many lines as the original
  std::vector<Edit> edits;
  std::vector<Spelling> ledger = {};
  std::string compiled_name = {};     // as in __FILE__
  std::vector<Edit> annotations = {}; // edits that only add annotations to the original; may be empty
};

// Layout of a structure's numbers, in the notation of <symreal/object_layout.h>.
struct ObjectLayout {
  std::string text;                    // empty: the object's type determines it
  std::vector<std::string> containers; // the types that the text refers to by number
};

// One dimension of an array section [low:length], in the source's own words.
struct Section {
  std::string low;
  std::string length;
};

// An #include of the file that defines the function.
struct Include {
  std::string name;   // as spelled, with its quotes or angle brackets
  std::string beside; // the real path of a header found beside the file; else empty
  bool operator==(Include const &) const = default;
};

// Values that a recording bakes in, and that may differ in another call: a wrapper compares them.
struct Baked {
  std::string label;
  std::string expression; // without its sections
  std::vector<Section> sections;
  std::string shape;      // of each element (rewrite/model/signature.h)
  bool is_object = false; // the non-numeric part of an annotated object: it counts if the kernel has read it
  Place place;
};

// Two items, by their labels, that may alias in another call.
struct Overlap {
  std::string first, second;
  bool first_in_rows = false, second_in_rows = false; // each row may alias on its own
  // Statements, one of which suffices, that make one alias the other when the function begins; empty if neither can.
  // `calls`: the function calls itself so, once.
  std::string first_there, second_there;
  bool calls = false;
};

// Return value of a function, as an object that a wrapper fills.
struct ReturnedObject {
  enum class Form { number, integer, members, walked, bytes };
  Form form = Form::number;
  std::string type;
  std::string obstacle; // why no wrapper can make one; else empty
  std::string begin;    // of the macro that annotates it, up to the value
  // Its members that are not numbers, for the program that tries a wrapper: { what "+" offset ";" } with
  //   what := "b" size   bytes: integers, truth values, enumerators, float
  //         | "p"        a pointer: whether it is null
  //         | "t"        a pointer to text that a null character ends
  //         | "s"        a std::string
  std::string others;
};

// Text that a file of its own needs to define the function instead of the original.
struct Redefinition {
  std::string obstacle;                  // why no other file can define it; else empty
  std::string qualified;                 // its name, with all scopes
  std::string head;                      // of the definition, behind these:
  std::vector<Include> includes;         // in the order of the source
  std::vector<std::string> declarations; // of variables without a declaration in a header
  std::vector<std::string>
      namespaces;                   // to reopen for a function without a declaration in a header, the outermost first
  std::vector<std::string> missing; // names visible in the original's file only
  std::vector<std::string> varying; // names in its items that may have another value in each call
  std::string mangled;
  // Arguments that pass its parameters on, and parameters of a function of C linkage, `symreal_self` for `this` first.
  std::string arguments, parameters, returned;
  bool has_this = false;
  // Always set: the begin of its body, behind the brace, in the file with this real path.
  std::string file;
  std::size_t body = 0;
  bool is_template = false;
  std::vector<Baked> baked;
  std::vector<Overlap> overlaps;
  ReturnedObject result;
};

// Interface of a kernel's function, for other files that call it or define it in its place.
struct Signature {
  std::string declaration; // without its `;`
  // Arguments that pass its parameters on; nullopt unless it can be declared under another name (model/signature.h).
  std::optional<std::string> arguments;
  bool returns_value = false;
  Redefinition redefinition = {};
};

struct Annotation {
  std::string kind; // input, parameter, constant, scratch or output
  std::string label;
  Place place;
  std::string expression; // the item without its sections; "return" for the returned value
  std::vector<Section> sections;
  ObjectLayout layout = {};
};

// A kernel requested by `generate` or by a function pragma.
struct Kernel {
  std::string name;
  bool is_function = false;
  bool by_hand = false; // by calls of <symreal/symbolic_main.h>
  Place place;
  std::string output_file; // the name in generate("..."), else empty
  Signature signature;
  std::vector<Annotation> annotations;
  std::string source; // display path of the file that holds the pragma
};

// A function that carries REAL and is declared within the roots, that the sources use and none of them defines. A
// compiled library's definition works on double: linking it would mix the two silently.
struct Boundary {
  std::string name;    // qualified
  std::string mangled; // as in the numeric program
  std::size_t parameters = 0;
  Place place; // of the declaration
  Place use;   // of its call
};

// A declaration or assignment that gives a number its name in the source.
struct NamedStatement {
  Place begin, end; // of the value's first and last token; an assignment begins with its target
  std::string name;
};

// A value that the program may decide on, in the source's words.
struct DecidingText {
  Place keyword;         // `if`, `while`, `?`, ... that decides on all of it; unset for an operand
  Place begin, end;      // of its first and last token
  std::string text;      // on one line, truncated with "..."
  std::string type = {}; // target of a conversion
};

// An `if`, a `?:` or a loop on a condition of REALs that cannot become a select.
struct Refusal {
  Place condition;        // begin of the condition
  unsigned last_line = 0; // of the condition
  Reason reason;          // "because of ..."
  Place token;            // the construct that prevents a select
};

// A decision on REALs: whether both of its arms can be recorded, and if not, the reason.
struct Decision {
  Place place;
  std::string kind; // if, ?:, for, while, do
  bool selectable;
  Reason reason = {};
  Place token = {};
};

// A conversion of a REAL to an integer, to float or to long double.
struct Conversion {
  Place place;
  std::string type;
  bool to_integer;
};

struct Result {
  std::vector<File> files;                 // sorted by path; empty when a source does not compile
  std::string type_name = usual_type_name; // the sources' spelling of the number
  std::vector<Kernel> kernels;
  std::vector<std::string> include_dirs; // header search directories of the sources, in order, once each
  std::vector<std::string> read;         // real paths of all files that were read, without the system's
  std::vector<Boundary> boundaries;      // each also has its diagnostic
  std::vector<std::string> definitions;  // mangled names of exported functions that carry REAL
  std::vector<NamedStatement> names;     // by file, line and column
  std::vector<DecidingText> deciding;
  std::vector<Refusal> refusals;   // in the order of their places
  std::vector<Decision> decisions; // by file and offset
  std::vector<Conversion> conversions;
  std::vector<std::string> changeable;           // as in Facts
  std::vector<std::string> externals;            // mangled names of functions that stay calls
  std::size_t comparisons = 0;                   // of REALs
  std::vector<std::string> left_out;             // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached;            // sources that the program does not reach
  std::size_t sources_read = 0;                  // by Clang
  std::size_t sources_kept = 0;                  // unchanged since an earlier run read them
  std::map<std::string, double> reading_seconds; // processor time, by the real path of a source that was read
  std::vector<Diagnostic> diagnostics;
};

} // namespace symreal::rewrite
