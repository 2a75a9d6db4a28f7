// What the rewriter gives: the rewritten files, and what it learned about the program that they make.
#pragma once

#include "rewrite/facts/reason.h"
#include "rewrite/facts/signature.h"
#include "rewrite/request/request.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace symreal::rewrite {

// A replacement on the original bytes of a file. Its length is never zero: an insertion takes the neighbouring
// character with it, so that an edit says where it belongs even when two sources ask for it.
struct Edit {
  std::size_t offset;
  std::size_t length;
  std::string text;
  auto operator<=>(Edit const &) const = default;
};

// What becomes of a `double` that a file spells.
enum class Fate {
  converted, // to REAL
  follows,   // converted as its neighbours are: the syntax tree does not say what it is part of
  passive,   // compiled, and stays
  diagnosed, // compiled, and an error says why it cannot be converted
  inactive,  // not compiled in this configuration
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
  std::string display_path; // as the user or the including file named it
  std::string original;
  std::string text; // the original with its edits; it has as many lines as the original
  std::vector<Edit> edits;
  std::vector<Spelling> ledger = {};
  std::string compiled_name = {};     // as __FILE__ has it
  std::vector<Edit> annotations = {}; // those that leave the original with its annotations alone; may be none
};

// Where the numbers of a structure lie, as <symreal/object_layout.h> reads it.
struct ObjectLayout {
  std::string text;                    // empty: the object's type tells
  std::vector<std::string> containers; // the types that the text refers to by number
};

struct Annotation {
  std::string kind; // input, parameter, constant, scratch or output
  std::string label;
  Place place;
  std::string expression; // the item without its sections; "return" for the returned value
  std::vector<Section> sections;
  ObjectLayout layout = {};
};

// What `generate`, or a function with a pragma, asks for.
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

// A function that carries REAL and is declared within the roots, that the sources use and none of them defines. What a
// compiled library would supply under its name works on double: linking it would mix the two silently.
struct Boundary {
  std::string name;    // qualified
  std::string mangled; // as in the numeric program
  std::size_t parameters = 0;
  Place place; // of the declaration
  Place use;   // where it is called
};

// A declaration or assignment that gives a number its name in the source.
struct NamedStatement {
  Place begin, end; // of the value's first and last token; an assignment begins with its target
  std::string name;
};

// Where the program may decide on a value, in the source's words.
struct DecidingText {
  Place keyword;         // `if`, `while`, `?`, ...: where a decision on the whole of it stands; none: it is an operand
  Place begin, end;      // of its first and last token
  std::string text;      // on one line, cut off with "..." where it gets long
  std::string type = {}; // of a conversion: what to
};

// An `if`, a `?:` or a loop on a condition of REALs that cannot become a select.
struct Refusal {
  Place condition;        // where the condition begins
  unsigned last_line = 0; // of the condition
  Reason reason;          // "because of ..."
  Place token;            // what is in the way
};

// A decision on REALs: whether both of its arms can be recorded, and if not, what is in the way.
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
  std::string type_name = usual_type_name; // how they spell the number
  std::vector<Kernel> kernels;
  std::vector<std::string> include_dirs; // header search directories of the sources, in order, once each
  std::vector<std::string> read;         // real paths of all files that were read, those of the system left out
  std::vector<Boundary> boundaries;      // each also has its diagnostic
  std::vector<std::string> definitions;  // mangled names of the functions that carry REAL and that others can use
  std::vector<NamedStatement> names;     // by file, line and column
  std::vector<DecidingText> deciding;
  std::vector<Refusal> refusals;   // in the order of their places
  std::vector<Decision> decisions; // by file and offset
  std::vector<Conversion> conversions;
  std::vector<std::string> changeable;           // as in Facts
  std::vector<std::string> externals;            // mangled names of functions that stay calls
  std::size_t comparisons = 0;                   // of REALs
  std::vector<std::string> left_out;             // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached;            // sources in which the program reaches nothing
  std::size_t sources_read = 0;                  // by Clang
  std::size_t sources_kept = 0;                  // of which an earlier run has read what they are now
  std::map<std::string, double> reading_seconds; // of the processor, by the real path of a source that was read
  std::vector<Diagnostic> diagnostics;
};

} // namespace symreal::rewrite
