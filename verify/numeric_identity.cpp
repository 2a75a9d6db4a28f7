#include "verify/numeric_identity.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/parallel.h"
#include "program/build/compiler_messages.h"
#include "program/build/overlay.h"
#include "program/build/process.h"
#include "rewrite/request/driver_options.h"

#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Mirror of the rewritten files: each lies below `top` at its real path.
class Shadow {
public:
  Shadow(rewrite::Result const &rewritten, std::string top) : rewritten_(rewritten), top_(std::move(top)) {
    for (rewrite::File const &file : rewritten.files) {
      fs::create_directories(fs::path(top_ + file.path).parent_path());
      write_if_changed(top_ + file.path, file.text);
    }
    link_neighbours(rewritten, top_);
  }

  // The mirror's path of this directory or file, if it exists there.
  std::optional<std::string> counterpart(fs::path const &name) const {
    std::error_code error;
    std::string const path = top_ + fs::weakly_canonical(name, error).string();
    return !error && fs::exists(path) ? std::optional(path) : std::nullopt;
  }

  // Original directories of the rewritten files, where they find excluded files.
  std::set<std::string> directories() const {
    std::set<std::string> found;
    for (rewrite::File const &file : rewritten_.files) found.insert(fs::path(file.path).parent_path().string());
    return found;
  }

  // The rewritten file that this name denotes to a compiler.
  rewrite::File const *file(std::string const &name) const {
    std::error_code error;
    std::string const real = fs::weakly_canonical(name, error).string();
    for (rewrite::File const &one : rewritten_.files)
      if (real == top_ + one.path) return &one;
    return nullptr;
  }

  // Flag that gives the files the names of the originals.
  std::string names() const { return "-ffile-prefix-map=" + top_ + "="; }

private:
  rewrite::Result const &rewritten_;
  std::string const top_;
};

// Names of the mirror in one compilation. A header has a name for each directory and including file by which it is
// found, and __FILE__ is the one used. So each name of a directory gets its own symbolic link to its counterpart, which
// a prefix map turns back.
class ShadowNames {
public:
  // `links`: a directory for this compilation alone.
  ShadowNames(Shadow const &shadow, std::string directory, std::string links, std::string const &compiler)
      : shadow_(shadow),
        directory_(std::move(directory)),
        links_(std::move(links)),
        is_clang_(compiler.find("clang") != compiler.npos) {
    constexpr char const *keep_dots = "-fno-file-reproducible"; // otherwise clang drops "./" from mapped names
    if (is_clang_ && capture({.arguments = {compiler, keep_dots, "-E", "-x", "c", "/dev/null"}}).outcome.success())
      maps.emplace_back(keep_dots);
    maps.push_back(shadow_.names());
  }

  std::optional<std::string> directory(std::string const &name) {
    auto const found = shadow_.counterpart(fs::path(directory_) / name);
    std::size_t const last = name.find_last_not_of('/'); // compilers drop trailing slashes
    return found ? std::optional(link(*found, name.substr(0, last + 1), "")) : std::nullopt;
  }

  std::optional<std::string> file(std::string const &name) {
    std::string const within = name.substr(0, name.rfind('/') + 1), last = name.substr(within.size());
    auto const found = shadow_.counterpart(fs::path(directory_) / within);
    if (!found || !fs::exists(*found + "/" + last)) return std::nullopt;
    std::string path = link(*found, within, "/") + last;
    // An included file beside its includer is named "file.h" by gcc, "./file.h" by clang.
    if (is_clang_ && within.empty()) {
      maps.back() += "./";
      maps.push_back("-ffile-prefix-map=" + path + "=" + last);
    }
    return path;
  }

  Words maps; // flags that map the links back

private:
  std::string link(std::string const &target, std::string const &name, char const *slash) {
    // The number keeps each link's name from being a prefix of another's.
    std::string const path = links_ + "/" + std::to_string(maps.size()) + "_";
    fs::create_directory_symlink(target, path);
    maps.push_back("-ffile-prefix-map=" + path + slash + "=" + name);
    return path + slash;
  }

  Shadow const &shadow_;
  std::string const directory_, links_;
  bool const is_clang_;
};

// Flags without those that choose outputs; the result is an object of machine code.
Words compiling(Words const &flags) {
  using rewrite::About;
  Words words =
      rewrite::without(flags, {About::output, About::action, About::dependencies, About::question, About::link_time});
  std::erase_if(words, [](std::string const &word) { return word.starts_with("-Werror"); });
  return words;
}

Words in_shadow(Words const &flags, Shadow const &shadow, std::string const &directory, ShadowNames &names) {
  std::vector<std::string> searched;
  Words words = search_flags(
      flags,
      [&](std::string const &name) {
        std::error_code error;
        return fs::is_directory(fs::path(directory) / name, error) ? names.directory(name) : names.file(name);
      },
      searched);
  std::set<std::string> last = shadow.directories();
  for (std::string const &one : searched) last.erase(fs::weakly_canonical(fs::path(directory) / one).string());
  for (std::string const &one : last) words.insert(words.end(), {"-idirafter", one});
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
  return {false, {}, compiled.output};
}

// Command lines of one source before and after rewriting.
struct Pair {
  Words before, after;
  std::string directory;
  Object original, changed;
};

// `name_flags`: flags that define the number's type name.
Pair prepare(rewrite::Compilation const &one, Shadow const &shadow, Compilers const &compilers, Words const &name_flags,
             std::string const &links) {
  Pair pair;
  pair.directory = one.directory.empty() ? fs::current_path().string() : one.directory;
  bool const is_c = one.source.ends_with(".c");
  std::string const &asked = is_c ? compilers.c : compilers.cxx;
  std::string const known = one.compiler.empty() ? (is_c ? "cc" : "c++") : one.compiler;
  pair.before = {asked.empty() ? known : asked};
  Words const flags = compiling(one.flags);
  ShadowNames names(shadow, pair.directory, links, pair.before[0]);
  Words const adapted = in_shadow(flags, shadow, pair.directory, names);
  std::string const source = names.file(one.source).value_or(one.source);
  pair.after = {pair.before[0], "-isystem", runtime_include()};
  pair.after.insert(pair.after.end(), name_flags.begin(), name_flags.end());
  pair.before.insert(pair.before.end(), flags.begin(), flags.end());
  pair.after.insert(pair.after.end(), adapted.begin(), adapted.end());
  pair.before.push_back(one.source);
  pair.after.insert(pair.after.end(), names.maps.begin(), names.maps.end());
  pair.after.push_back(source);
  return pair;
}

// Line of a compiler's message with file name and column mapped to the original.
std::string in_original(std::string const &line, Shadow const &shadow) {
  std::optional<MessageLine> const message = message_line(line);
  if (!message) return line;
  rewrite::File const *file = shadow.file(message->place.file);
  if (!file) return line;
  Place const &place = message->place;
  return message->before + to_string(original_place(*file, {file->display_path, place.line, place.column})) +
         message->rest;
}

std::string whole_message(std::string const &output, Shadow const &shadow) {
  // A single line follows on the message's own line.
  if (output.find('\n') + 1 >= output.size() || output.find('\n') == output.npos)
    return " " + output.substr(0, output.find('\n'));
  std::string text;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) text += "\n    " + in_original(line, shadow);
  return text;
}

} // namespace

ObjectComparison compare_object_code(std::vector<rewrite::Compilation> const &sources, rewrite::Result const &rewritten,
                                     Compilers const &compilers, unsigned jobs, Workspace const &workspace) {
  Shadow const shadow(rewritten, workspace.directory("shadow"));
  std::vector<Pair> pairs;
  pairs.reserve(sources.size());
  Words const name_flags = rewrite::type_name_flags(rewritten.type_name);
  for (rewrite::Compilation const &one : sources)
    pairs.push_back(
        prepare(one, shadow, compilers, name_flags, workspace.directory("names_" + std::to_string(pairs.size()))));
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
      result.diagnostics.push_back(
          {DiagnosticId::numeric_original, place, "the compiler says:" + whole_message(unchanged.output, shadow)});
    else if (++result.compared; !changed.made)
      result.diagnostics.push_back({DiagnosticId::numeric_difference, place,
                                    "the rewritten source does not compile:" + whole_message(changed.output, shadow)});
    else if (changed.code != unchanged.code)
      result.diagnostics.push_back({DiagnosticId::numeric_difference, place,
                                    "the object code of the rewritten source differs from the original's"});
    else
      ++result.identical;
  }
  return result;
}

} // namespace symreal::program
