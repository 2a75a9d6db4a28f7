// What is asked of the rewriter: the sources as their builds compile them, and what may be rewritten.
#pragma once

#include "engine/diagnostics/diagnostic.h"

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
  std::string compiler = {};             // the build's own; empty: not known
  std::vector<std::string> defines = {}; // what else is told to the compiler of the rewritten source: -DNAME
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
  std::vector<ConfiguredText> derivatives = {};
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
  std::vector<std::string> sources; // as the user named them; a name ending in .c is parsed as C
  std::vector<std::string> roots;   // what may be rewritten besides the directories of the sources
  std::vector<std::string> flags;   // the compiler flags of every source
  // What the build of the rewritten sources defines besides: -DNAME. A macro may decide what the sources are.
  std::vector<std::string> defines = {};
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
  bool annotations_only = false; // of the texts nothing else changes: the original with its annotations
  bool children_first = false;   // visit them before their parents: a test shows that the order does not matter
};

// What a compiler must be told so that it knows the number under this name, besides where Symreal's headers are.
std::vector<std::string> type_name_flags(std::string const &type_name);

// The request's compilations, or its sources with its flags; with what its build defines.
std::vector<Compilation> compilations_of(Request const &request);

// The real path of a compilation's source.
std::string real_source(Compilation const &compilation);

// The real path of a file or directory, of one that does not exist in its directory's; the name itself where that does
// not exist either.
std::string real_path(std::string const &name);

} // namespace symreal::rewrite
