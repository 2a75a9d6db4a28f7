#include "program/numeric_identity.h"

#include "program/neighbours.h"
#include "program/parallel.h"
#include "program/process.h"
#include "program/search_flags.h"
#include "rewrite/pragma_text.h"
#include "support/files.h"
#include "support/installation.h"

#include <filesystem>
#include <optional>
#include <set>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Where the rewritten files lie: each below `top`, at its real path.
class Shadow {
public:
  Shadow(rewrite::Result const &rewritten, std::string top) : rewritten_(rewritten), top_(std::move(top)) {
    for (rewrite::File const &file : rewritten.files) write(file, file.compiled_name);
    link_neighbours(rewritten, top_);
  }

  // The source under the name that this compilation gives it.
  std::string source(std::string const &real, std::string const &name) const {
    for (rewrite::File const &file : rewritten_.files)
      if (file.path == real) write(file, name);
    return top_ + real;
  }

  // The directory's or file's counterpart, if there is one.
  std::optional<std::string> counterpart(std::string const &name, std::string const &directory) const {
    std::error_code error;
    std::string const path = top_ + fs::weakly_canonical(fs::path(directory) / name, error).string();
    return !error && fs::exists(path) ? std::optional(path) : std::nullopt;
  }

  // Where else a rewritten file finds what is left as it is: what the configuration excludes.
  std::set<std::string> directories() const {
    std::set<std::string> found;
    for (rewrite::File const &file : rewritten_.files) found.insert(fs::path(file.path).parent_path().string());
    return found;
  }

  // So that the files have the names of the originals.
  std::string names() const { return "-ffile-prefix-map=" + top_ + "="; }

private:
  void write(rewrite::File const &file, std::string const &name) const {
    std::string const path = top_ + file.path;
    fs::create_directories(fs::path(path).parent_path());
    std::size_t const mark = file.text.starts_with("\xEF\xBB\xBF") ? 3 : 0; // one only at the very beginning
    write_if_changed(path,
                     file.text.substr(0, mark) + "#line 1 " + rewrite::quoted(name) + "\n" + file.text.substr(mark));
  }

  rewrite::Result const &rewritten_;
  std::string const top_;
};

// Without what chooses outputs; an object is wanted, of machine code.
Words compiling(Words const &flags) {
  Words words;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    std::string const &flag = flags[i];
    if (flag == "-o" || flag == "-MF" || flag == "-MT" || flag == "-MQ")
      ++i;
    else if (flag != "-c" && flag != "-S" && flag != "-E" && !flag.starts_with("-M") && !flag.starts_with("-flto") &&
             !flag.starts_with("-Werror"))
      words.push_back(flag);
  }
  return words;
}

Words in_shadow(Words const &flags, Shadow const &shadow, std::string const &directory) {
  std::vector<std::string> searched;
  Words words =
      search_flags(flags, [&](std::string const &name) { return shadow.counterpart(name, directory); }, searched);
  std::set<std::string> last = shadow.directories();
  for (std::string const &one : searched) last.erase(fs::weakly_canonical(fs::path(directory) / one).string());
  for (std::string const &one : last) words.insert(words.end(), {"-idirafter", one});
  words.push_back(shadow.names());
  return words;
}

struct Object {
  bool made = false;
  std::string code, output;
};

Object compile(Words words, std::string const &file, std::string const &directory) {
  words.insert(words.end(), {"-w", "-c", "-o", file});
  Captured compiled = capture({.arguments = words, .directory = directory, .environment = {"LC_ALL=C"}});
  if (compiled.outcome.success()) {
    compiled = capture({.arguments = {"strip", "--strip-unneeded", file}});
    if (compiled.outcome.success()) return {true, read_file(file), {}};
  }
  if (compiled.outcome.ending == Ending::not_started) return {false, {}, "'" + words[0] + "' cannot be started"};
  return {false, {}, compiled.output.substr(0, compiled.output.find('\n'))};
}

// One source before and after, as command lines.
struct Pair {
  Words before, after;
  std::string directory;
  Object original, changed;
};

// `name_flags`: what the compiler must be told about the number's name.
Pair prepare(rewrite::Compilation const &one, Shadow const &shadow, Compilers const &compilers,
             Words const &name_flags) {
  Pair pair;
  pair.directory = one.directory.empty() ? fs::current_path().string() : one.directory;
  bool const is_c = one.source.ends_with(".c");
  std::string const &asked = is_c ? compilers.c : compilers.cxx;
  std::string const known = one.compiler.empty() ? (is_c ? "cc" : "c++") : one.compiler;
  Words const flags = compiling(one.flags);
  Words const adapted = in_shadow(flags, shadow, pair.directory);
  pair.before = {asked.empty() ? known : asked};
  pair.after = {pair.before[0], "-isystem", runtime_include()};
  pair.after.insert(pair.after.end(), name_flags.begin(), name_flags.end());
  pair.before.insert(pair.before.end(), flags.begin(), flags.end());
  pair.after.insert(pair.after.end(), adapted.begin(), adapted.end());
  pair.before.push_back(one.source);
  pair.after.push_back(shadow.source(rewrite::real_source(one), one.source));
  return pair;
}

} // namespace

ObjectComparison compare_object_code(std::vector<rewrite::Compilation> const &sources, rewrite::Result const &rewritten,
                                     Compilers const &compilers, unsigned jobs, Workspace const &workspace) {
  Shadow const shadow(rewritten, workspace.directory("shadow"));
  std::vector<Pair> pairs;
  pairs.reserve(sources.size());
  Words const name_flags = rewrite::type_name_flags(rewritten.type_name);
  for (rewrite::Compilation const &one : sources) pairs.push_back(prepare(one, shadow, compilers, name_flags));
  in_parallel(2 * pairs.size(), jobs, [&](std::size_t k) {
    Pair &pair = pairs[k / 2];
    bool const is_original = k % 2 == 0;
    (is_original ? pair.original : pair.changed) =
        compile(is_original ? pair.before : pair.after, workspace.file(std::to_string(k) + ".o"), pair.directory);
  });
  ObjectComparison result;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    Object const &unchanged = pairs[k].original, &changed = pairs[k].changed;
    Place const place{sources[k].source};
    if (!unchanged.made)
      result.diagnostics.push_back({DiagnosticId::numeric_original, Severity::error, place, unchanged.output});
    else if (++result.compared; !changed.made)
      result.diagnostics.push_back({DiagnosticId::numeric_difference, Severity::error, place,
                                    "the rewritten source does not compile: " + changed.output});
    else if (changed.code != unchanged.code)
      result.diagnostics.push_back({DiagnosticId::numeric_difference, Severity::error, place,
                                    "the object code of the rewritten source differs from the original's"});
    else
      ++result.identical;
  }
  return result;
}

} // namespace symreal::program
