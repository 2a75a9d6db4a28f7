// Source to symbolic program: rewrites `double` to REAL and `#pragma symreal` lines to annotation macros.
//
//   sources ──record──▶ facts ──decide──▶ rewordings, kernels, diagnostics ──compose──▶ files
//             Clang               plain                                       plain
//
// This library is the only place that knows Clang, and nothing of Clang shows in this header. It reads files and
// writes none: what becomes of the texts (an overlay, a diff, a mirror) is the caller's matter.
#pragma once

#include "diagnostics/diagnostic.h"
#include "rewrite/signature.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace symreal::rewrite {

// A source as its build compiles it.
struct Compilation {
  std::string source;
  std::string directory; // in which the compiler runs; empty: that of this process
  std::vector<std::string> flags;
  std::string compiler = {}; // the build's own; empty: not known
};

// What compile_commands.json in the directory says about these sources, or about all of C and C++ if none are named;
// response files are read. Throws compile_commands.
std::vector<Compilation> read_compile_commands(std::string const &directory, std::vector<std::string> const &sources);

// Files that are left as they are although they lie below a root. A pattern is a path below `directory`, in which `*`
// stands for anything but a slash and `**` for any directories; without a slash it is a name at any depth. What matches
// a directory excludes all that is below.
struct Exclusion {
  std::string directory; // a real path
  std::vector<std::string> patterns;
  bool matches(std::string const &real_path) const;
};

// What a project's configuration says instead of a pragma in the source, and where it says so.
struct ConfiguredText {
  std::string text;
  Place place;
};
struct ConfiguredClause {
  ConfiguredText name;
  std::vector<ConfiguredText> items;
};
// As if `#pragma symreal function` with these clauses stood before the function's definition.
struct ConfiguredKernel {
  ConfiguredText function; // its qualified name, with the types of its parameters where several have that name
  std::string file = {};   // the real path of the file that defines it; empty: any
  std::vector<ConfiguredClause> clauses = {};
};
// As if `#pragma symreal external` stood in each source that sees a declaration of the function.
struct ConfiguredExternal {
  ConfiguredText function;
  bool pure = false;
  std::vector<ConfiguredClause> clauses = {};
};

// A source that lies in no file: read and compiled as if it stood at this path.
struct TextSource {
  std::string path; // real
  std::string text;
};

// How the rewritten sources spell the number, if the request does not say: `usual_type_name`, or, where the sources use
// that for something else, `reserved_type_name`.
inline constexpr char const *usual_type_name = "REAL";
inline constexpr char const *reserved_type_name = "SYMREAL_REAL";

// Texts that are kept from run to run, each under a key of letters and digits. Several threads use it at once.
class KeptTexts {
public:
  virtual ~KeptTexts() = default;
  virtual std::optional<std::string> find(std::string const &key) = 0;
  virtual void keep(std::string const &key, std::string const &text) = 0; // what cannot be kept will not be found
};

struct Request {
  std::vector<std::string> sources;           // as the user named them; a name ending in .c is parsed as C
  std::vector<std::string> roots;             // what may be rewritten besides the directories of the sources
  std::vector<std::string> flags;             // the compiler flags of every source
  bool leave_out_broken = false;              // go on without the sources that do not compile
  std::vector<Compilation> compilations = {}; // if any, instead of sources and flags
  unsigned jobs = 0;                          // sources that are read at once, 0: one; the result does not depend on it
  Exclusion exclude = {};
  std::string type_name = {}; // how the number is spelled; empty: see above
  std::vector<ConfiguredKernel> kernels = {};
  std::vector<ConfiguredExternal> externals = {};
  std::vector<TextSource> texts = {};   // of those sources that are in no file
  std::shared_ptr<KeptTexts> kept = {}; // what earlier runs have read; none: all sources are read
  // Only the sources that define what the program's start reaches. `begin`: the sources to begin with, by their real
  // paths; none: those in `texts`, or else the one that defines main.
  bool reachable = false;
  std::vector<std::string> begin = {};
};

// The request's compilations, or its sources with its flags.
std::vector<Compilation> compilations_of(Request const &request);

// The real path of a compilation's source.
std::string real_source(Compilation const &compilation);

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

// One dimension of an array section [low:length], in the source's own words.
struct Section {
  std::string low;
  std::string length;
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
  std::string reason;     // "because of ..."
  Place token;            // what is in the way
};

// A decision on REALs: whether both of its arms can be recorded, and if not, what is in the way.
struct Decision {
  Place place;
  std::string kind; // if, ?:, for, while, do
  bool selectable;
  std::string reason = {};
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
  std::vector<std::string> externals; // mangled names of functions that stay calls
  std::size_t comparisons = 0;        // of REALs
  std::vector<std::string> left_out;  // sources that do not compile, if the request allows it
  std::vector<Compilation> unreached; // sources in which the program reaches nothing
  std::size_t sources_read = 0;       // by Clang
  std::size_t sources_kept = 0;       // of which an earlier run has read what they are now
  std::vector<Diagnostic> diagnostics;
};

// The files with annotations, each with these alone: what verification compiles as the original. `kernels` and the like
// are left out.
Result annotated_original(Result const &result);

// Throws DiagnosticError only for a source that cannot be read; all else is found in Result::diagnostics.
Result run(Request const &request);

// What a compiler must be told so that it knows the number under this name, besides where Symreal's headers are.
std::vector<std::string> type_name_flags(std::string const &type_name);

// `diff -u` of the original and the rewritten text; empty when nothing changed.
std::string unified_diff(File const &file);

// Writes the mirror of the files under `directory`, each at its path below `top` or, if that is empty, below the
// deepest directory that all share, and returns the written paths. All files must lie below `top`, a real path. Every
// file begins with a #line directive, so that places and assertions keep their names.
std::vector<std::string> write_mirror(std::vector<File> const &files, std::string const &directory,
                                      std::string const &top = {});

} // namespace symreal::rewrite
