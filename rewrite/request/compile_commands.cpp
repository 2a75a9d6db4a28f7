#include "rewrite/request/driver_options.h"
#include "rewrite/request/request.h"

#include <clang/Tooling/JSONCompilationDatabase.h>
#include <llvm/Support/Path.h>

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

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

Compilation compilation(tooling::CompileCommand const &command) {
  Compilation result{command.Filename, command.Directory, {}, {}};
  if (!command.CommandLine.empty()) result.compiler = command.CommandLine[0];
  std::string const source = absolute(command.Directory, command.Filename);
  bool says_language = false;
  std::vector<std::string> words = command.CommandLine;
  if (!words.empty()) words.erase(words.begin());
  std::erase(words, "--");
  for (DriverOption const &option : driver_options(words)) {
    says_language |= option.about == About::language;
    if (option.about == About::input && absolute(command.Directory, option.value) == source)
      result.source = option.value; // as __FILE__ has it
    else if (option.about != About::output)
      append(result.flags, option, words);
  }
  // g++ compiles all of its sources as C++.
  if (!says_language && llvm::sys::path::filename(result.compiler).contains("++") && result.source.ends_with(".c"))
    result.flags.insert(result.flags.end(), {"-x", "c++"});
  return result;
}

} // namespace

std::vector<Compilation> read_compile_commands(std::string const &directory, std::vector<std::string> const &sources) {
  std::string const file = directory + "/compile_commands.json";
  std::string problem;
  std::unique_ptr<tooling::CompilationDatabase> database =
      tooling::JSONCompilationDatabase::loadFromFile(file, problem, tooling::JSONCommandLineSyntax::AutoDetect);
  if (!database) fail(DiagnosticId::compile_commands, {file}, problem);
  database = tooling::expandResponseFiles(std::move(database), llvm::vfs::getRealFileSystem());
  std::vector<std::string> wanted, found;
  for (std::string const &source : sources) wanted.push_back(real_path(source));
  std::vector<Compilation> result;
  for (tooling::CompileCommand const &command : database->getAllCompileCommands()) {
    if (!is_c_or_cxx(command.Filename)) continue;
    std::string const real = real_path(absolute(command.Directory, command.Filename));
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), real) == wanted.end()) continue;
    found.push_back(real);
    result.push_back(compilation(command));
  }
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (std::find(found.begin(), found.end(), wanted[i]) == found.end())
      fail(DiagnosticId::compile_commands, {file}, "there is no entry for '" + sources[i] + "'");
  if (result.empty()) fail(DiagnosticId::compile_commands, {file}, "there is no entry for a C or C++ source");
  return result;
}

} // namespace symreal::rewrite
