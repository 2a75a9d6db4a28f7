// Request to the rewriter: the sources as their builds compile them, and the files that may be rewritten.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::rewrite {

// A source as its build compiles it.
struct Compilation {
  std::string source;
  std::string directory; // in which the compiler runs; empty: that of this process
  std::vector<std::string> flags;
  std::string compiler = {};             // the build's own; empty: unknown
  std::vector<std::string> defines = {}; // further flags for the compiler of the rewritten source: -DNAME
};

// Compilations of these sources, or of all of C and C++ if none are named, from compile_commands.json in the directory;
// response files are read. Throws compile_commands.
std::vector<Compilation> read_compile_commands(std::string const &directory, std::vector<std::string> const &sources);

// Files below a root that are left as they are. A pattern is a path below `directory`, in which `*` stands for anything
// but a slash and `**` for any directories; without a slash it is a name at any depth. A pattern that matches a
// directory excludes all that is below.
struct Exclusion {
  std::string directory; // a real path
  std::vector<std::string> patterns;
  bool matches(std::string const &real_path) const;
};

// Text of a project's configuration in place of a pragma in the source, with its place.
struct ConfiguredText {
  std::string text;
  Place place;
};
struct ConfiguredClause {
  ConfiguredText name;
  std::vector<ConfiguredText> items;
};
// A kernel configured as if `#pragma symreal function` with these clauses stood before the function's definition.
struct ConfiguredKernel {
  ConfiguredText function; // its qualified name, with the types of its parameters if it is overloaded
  std::string file = {};   // the real path of the file that defines it; empty: any
  std::vector<ConfiguredClause> clauses = {};
};
// An external function configured as if `#pragma symreal external` stood in each source that declares it.
struct ConfiguredExternal {
  ConfiguredText function;
  bool pure = false;
  std::vector<ConfiguredClause> clauses = {};
  std::vector<ConfiguredText> derivatives = {};
};

// A source without a file: read and compiled as if it stood at this path.
struct TextSource {
  std::string path; // real
  std::string text;
};

// Name of the number in the rewritten sources, if the request does not set one: `usual_type_name`, or, if the sources
// use that for something else, `reserved_type_name`.
inline constexpr char const *usual_type_name = "REAL";
inline constexpr char const *reserved_type_name = "SYMREAL_REAL";

// Content hash that identifies a text, in letters and digits.
std::string content_id(std::string_view text);

// Cache of texts from run to run, each under a key of letters and digits. Thread-safe.
class KeptTexts {
public:
  virtual ~KeptTexts() = default;
  virtual std::optional<std::string> find(std::string const &key) = 0;
  virtual void keep(std::string const &key, std::string const &text) = 0; // failures are ignored
};

struct Request {
  std::vector<std::string> sources; // as the user spelled them; a name ending in .c is parsed as C
  std::vector<std::string> roots;   // directories that may be rewritten, besides those of the sources
  std::vector<std::string> flags;   // the compiler flags of every source
  // Macros that the build of the rewritten sources adds: -DNAME. A macro may select the code of a source.
  std::vector<std::string> defines = {};
  bool leave_out_broken = false;              // go on without the sources that do not compile
  std::vector<Compilation> compilations = {}; // if any, instead of sources and flags
  unsigned jobs = 0;                          // sources read in parallel, 0: one; the result does not depend on it
  Exclusion exclude = {};
  std::string type_name = {}; // name of the number; empty: see above
  std::vector<ConfiguredKernel> kernels = {};
  std::vector<ConfiguredExternal> externals = {};
  std::vector<TextSource> texts = {};   // of sources without a file
  std::shared_ptr<KeptTexts> kept = {}; // cache of earlier readings; null: all sources are read
  // Restricts the sources to those that define what the program's start reaches. `begin`: the sources to begin with, by
  // their real paths; empty: those in `texts`, or else the one that defines main.
  bool reachable = false;
  std::vector<std::string> begin = {};
  bool annotations_only = false; // the texts are the originals with their annotations
  bool children_first = false;   // visit children before parents: for a test that the order does not matter
};

// Compiler flags that define the number under this name, besides the include path of Symreal's headers.
std::vector<std::string> type_name_flags(std::string const &type_name);

// The request's compilations, or its sources with its flags; each with the request's `defines`.
std::vector<Compilation> compilations_of(Request const &request);

// The real path of a compilation's source.
std::string real_source(Compilation const &compilation);

// The real path of a file or directory; for a missing one, the name below its directory's real path, or the name itself
// if that is missing, too.
std::string real_path(std::string const &name);

} // namespace symreal::rewrite
