#include "rewrite/request/driver_options.h"
#include "rewrite/request/request.h"

#include <clang/Tooling/JSONCompilationDatabase.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/CommandLine.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/StringSaver.h>

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;
using Words = std::vector<std::string>;

std::string absolute(std::string const &directory, std::string const &name) {
  llvm::SmallString<256> path(name);
  llvm::sys::fs::make_absolute(directory, path);
  return path.str().str();
}

bool is_c_or_cxx(llvm::StringRef name) {
  llvm::StringRef const ending = llvm::sys::path::extension(name);
  for (llvm::StringRef known : {".c", ".cc", ".cp", ".cpp", ".cxx", ".c++", ".C", ".CC", ".CPP", ".CXX"})
    if (ending == known) return true;
  return false;
}

// NAME=value
bool is_assignment(llvm::StringRef word) {
  std::size_t const equal = word.find('=');
  return equal != word.npos && equal > 0 && (llvm::isAlpha(word[0]) || word[0] == '_') &&
         word.take_front(equal).find_if_not([](char c) { return llvm::isAlnum(c) || c == '_'; }) == word.npos;
}

// A program that runs a compiler with the words behind its own, and those of its options that have an operand.
struct Wrapper {
  llvm::StringRef name;
  std::vector<llvm::StringRef> with_operand;
};
std::vector<Wrapper> const wrappers = {
    {"env", {"-u", "--unset", "-C", "--chdir", "-S"}},
    {"nice", {"-n", "--adjustment"}},
    {"ionice", {"-c", "-n"}},
    {"time", {"-f", "-o"}},
    {"exec", {}},
    {"command", {}},
    {"nohup", {}},
    {"ccache", {}},
    {"sccache", {}},
    {"distcc", {}},
    {"icecc", {}},
    {"gomacc", {}},
    {"buildcache", {}},
    {"libtool", {}},
};

bool is_shell(llvm::StringRef name) { return name == "sh" || name == "bash" || name == "dash"; }

// The command line of one source in plain words: a shell's commands before it, the environment, and programs that run
// the compiler are taken away.
class PlainCommand {
public:
  PlainCommand(std::string const &database, tooling::CompileCommand const &command)
      : database_(database),
        file_(command.Filename),
        source_(real_path(absolute(command.Directory, command.Filename))),
        directory_(command.Directory) {
    Words words = command.CommandLine;
    take(words);
    if (words_.empty()) refuse("does not run a compiler on it");
  }

  Words const &words() const { return words_; } // the compiler first
  std::string const &directory() const { return directory_; }

private:
  [[noreturn]] void refuse(std::string const &why) const {
    fail(DiagnosticId::compile_commands, {database_}, "the command for '" + file_ + "' " + why);
  }

  // One command after the other, as `&&` joins them; that which names the source is the compiler's.
  void take(Words const &spelled) {
    Words const words = apart(spelled);
    Words one;
    for (std::size_t k = 0; k <= words.size(); ++k) {
      bool const ends = k == words.size() || words[k] == "&&" || words[k] == ";";
      if (!ends && skips_redirection(words, k)) continue;
      if (!ends) {
        one.push_back(words[k]);
        continue;
      }
      take_one(one);
      one.clear();
    }
  }

  // A shell needs no blanks around its signs: "(cd d&& cc -c a.c)"
  static Words apart(Words const &spelled) {
    Words words;
    bool const is_grouped = !spelled.empty() && spelled[0].starts_with('(') && spelled.back().ends_with(')');
    for (std::size_t k = 0; k < spelled.size(); ++k) {
      llvm::StringRef word = spelled[k];
      if (is_grouped && k == 0) word.consume_front("(");
      if (is_grouped && k + 1 == spelled.size()) word.consume_back(")");
      std::string sign;
      for (llvm::StringRef const one : {"&&", ";"})
        if (word != one && !word.starts_with("-") && word.consume_back(one)) sign = one.str();
      if (!word.empty()) words.push_back(word.str());
      if (!sign.empty()) words.push_back(sign);
    }
    return words;
  }

  // `2>&1`, `> log`
  bool skips_redirection(Words const &words, std::size_t &k) const {
    llvm::StringRef const word = llvm::StringRef(words[k]).ltrim("0123456789&");
    if (word == "|" || word == "||" || word == "<" || word.contains("$(") || word.contains('`'))
      refuse("is written for a shell, with '" + words[k] + "': name the compiler and its options alone");
    if (!word.starts_with(">")) return false;
    if (word.ltrim(">").empty()) ++k; // the file is a word of its own
    return true;
  }

  void take_one(Words words) {
    if (words.empty()) return;
    if (words[0] == "cd") {
      if (words.size() != 2) refuse("changes the directory with more than a name");
      directory_ = absolute(directory_, words[1]);
      return;
    }
    unwrap(words);
    if (words.empty() ||
        std::none_of(words.begin(), words.end(), [&](std::string const &word) { return is_source(word); }))
      return; // a command of another kind, such as mkdir
    if (!words_.empty()) refuse("names the source in two commands");
    llvm::StringRef const name = llvm::sys::path::stem(words[0]);
    if (name == "cl" || name == "clang-cl")
      refuse("has the options of Visual C++ ('" + words[0] + "'): configure the project for gcc or clang");
    words_ = std::move(words);
    words_.insert(words_.end(), directories_.begin(), directories_.end());
  }

  bool is_source(std::string const &word) const { return real_path(absolute(directory_, word)) == source_; }

  void unwrap(Words &words) {
    while (!words.empty()) {
      llvm::StringRef const name = llvm::sys::path::filename(words[0]);
      auto const wrapper = std::find_if(wrappers.begin(), wrappers.end(), [&](Wrapper const &one) {
        return one.name == name || (one.name + ".exe").str() == name;
      });
      if (is_assignment(words[0])) {
        assign(words[0]);
        words.erase(words.begin());
      } else if (is_shell(name) && words.size() == 3 && llvm::StringRef(words[1]).starts_with("-") &&
                 llvm::StringRef(words[1]).ends_with("c")) {
        Words const inner = split(words[2]);
        words.clear();
        take(inner);
      } else if (is_shell(name) && words.size() > 1 && llvm::sys::path::filename(words[1]) == "libtool")
        words.erase(words.begin());
      else if (wrapper != wrappers.end())
        skip_options(words, *wrapper);
      else
        return;
    }
  }

  void skip_options(Words &words, Wrapper const &wrapper) {
    words.erase(words.begin());
    while (!words.empty() && words[0].size() > 1 && words[0][0] == '-') {
      llvm::StringRef const option = words[0];
      bool const is_apart =
          std::find(wrapper.with_operand.begin(), wrapper.with_operand.end(), option) != wrapper.with_operand.end();
      if (is_apart && words.size() > 1 && (option == "-C" || option == "--chdir"))
        directory_ = absolute(directory_, words[1]);
      if (option.starts_with("--chdir=")) directory_ = absolute(directory_, option.split('=').second.str());
      words.erase(words.begin(), words.begin() + (is_apart && words.size() > 1 ? 2 : 1));
    }
  }

  // Adds the header directories that an environment variable sets for the compiler.
  void assign(llvm::StringRef word) {
    auto const [name, value] = word.split('=');
    bool const is_for_c = name == "C_INCLUDE_PATH", is_for_cxx = name == "CPLUS_INCLUDE_PATH";
    if (name != "CPATH" && !is_for_c && !is_for_cxx) return;
    if (is_for_c && !llvm::StringRef(file_).ends_with(".c")) return;
    if (is_for_cxx && llvm::StringRef(file_).ends_with(".c")) return;
    llvm::SmallVector<llvm::StringRef> all;
    value.split(all, ':');
    for (llvm::StringRef const one : all) {
      directories_.push_back(name == "CPATH" ? "-I" : "-isystem");
      directories_.push_back(one.empty() ? "." : one.str());
    }
  }

  static Words split(std::string const &text) {
    llvm::BumpPtrAllocator memory;
    llvm::StringSaver saver(memory);
    llvm::SmallVector<char const *> words;
    llvm::cl::TokenizeGNUCommandLine(text, saver, words);
    return {words.begin(), words.end()};
  }

  std::string const &database_;
  std::string file_, source_; // as the entry names it, and its real path
  std::string directory_;     // where the compiler runs
  Words words_, directories_;
};

Compilation compilation(std::string const &database, tooling::CompileCommand const &command) {
  PlainCommand const plain(database, command);
  Words words = plain.words();
  std::string const source = absolute(command.Directory, command.Filename);
  // The entry's directory is that of its file; a `cd` moves the compiler alone.
  Compilation result{command.Filename, plain.directory(), {}, words[0]};
  if (plain.directory() != command.Directory) result.source = source;
  bool says_language = false;
  words.erase(words.begin());
  std::erase(words, "--");
  for (DriverOption const &option : driver_options(words)) {
    says_language |= option.about == About::language;
    if (option.about == About::input && real_path(absolute(plain.directory(), option.value)) == real_path(source))
      result.source = option.value; // as __FILE__ has it
    else if (option.about == About::input && is_c_or_cxx(option.value))
      continue; // compiled in the same run, for another entry
    else if (option.about != About::output)
      append(result.flags, option, words);
  }
  // g++ compiles all of its sources as C++.
  if (!says_language && llvm::sys::path::filename(result.compiler).contains("++") && result.source.ends_with(".c"))
    result.flags.insert(result.flags.end(), {"-x", "c++"});
  return result;
}

// Whether entries of two targets compile a source alike, except for their outputs.
bool are_equal(Compilation const &one, Compilation const &other) {
  return one.directory == other.directory && one.compiler == other.compiler &&
         real_path(absolute(one.directory, one.source)) == real_path(absolute(other.directory, other.source)) &&
         without(one.flags, {About::dependencies}) == without(other.flags, {About::dependencies});
}

} // namespace

std::vector<Compilation> read_compile_commands(std::string const &directory, std::vector<std::string> const &sources) {
  std::string const file = directory + "/compile_commands.json";
  std::string problem;
  if (!llvm::sys::fs::exists(file)) fail(DiagnosticId::compile_commands, {file}, "the file does not exist");
  std::unique_ptr<tooling::CompilationDatabase> database =
      tooling::JSONCompilationDatabase::loadFromFile(file, problem, tooling::JSONCommandLineSyntax::AutoDetect);
  if (!database)
    fail(DiagnosticId::compile_commands, {file},
         "the file is not a list of entries with 'directory', 'file', and 'command' or 'arguments': " +
             llvm::StringRef(problem).rtrim().str());
  database = tooling::expandResponseFiles(std::move(database), llvm::vfs::getRealFileSystem());
  std::vector<std::string> wanted, found;
  for (std::string const &source : sources) wanted.push_back(real_path(source));
  std::vector<Compilation> result;
  for (tooling::CompileCommand const &command : database->getAllCompileCommands()) {
    if (!is_c_or_cxx(command.Filename)) continue;
    std::string const real = real_path(absolute(command.Directory, command.Filename));
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), real) == wanted.end()) continue;
    found.push_back(real);
    Compilation one = compilation(file, command);
    bool const is_known =
        std::any_of(result.begin(), result.end(), [&](Compilation const &other) { return are_equal(one, other); });
    if (!is_known) result.push_back(std::move(one));
  }
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (std::find(found.begin(), found.end(), wanted[i]) == found.end())
      fail(DiagnosticId::compile_commands, {file}, "there is no entry for '" + sources[i] + "'");
  if (result.empty()) fail(DiagnosticId::compile_commands, {file}, "there is no entry for a C or C++ source");
  return result;
}

} // namespace symreal::rewrite
