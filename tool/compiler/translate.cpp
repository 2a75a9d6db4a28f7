#include "tool/compiler/translate.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/text.h"
#include "program/build/c_macros.h"
#include "program/build/compile.h"
#include "program/build/compiler_messages.h"
#include "program/build/make_rule.h"
#include "program/build/read_files.h"
#include "rewrite/rewrite.h"
#include "tool/compiler/link.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

namespace symreal::compiler {
namespace {

namespace fs = std::filesystem;
using program::Overlay;
using program::Workspace;

// Fills in missing options: file and target are named after the output, as by gcc. Targets are escaped.
DependencyOptions completed(CommandLine const &line, std::string const &source) {
  DependencyOptions options = line.dependencies;
  fs::path const stem = fs::path(source).stem();
  bool const names_object = line.action != Action::link && !line.output.empty();
  if (options.targets.empty())
    options.targets.push_back(program::make_escaped(names_object ? line.output : stem.string() + ".o"));
  if (!options.file.empty()) return options;
  if (line.action == Action::link)
    options.file = (line.output.empty() ? "a" : line.output) + "-" + stem.string() + ".d";
  else
    options.file = names_object ? fs::path(line.output).replace_extension(".d").string() : stem.string() + ".d";
  return options;
}

void append(Words &words, Words const &more) { words.insert(words.end(), more.begin(), more.end()); }

// Diagnostics about definitions in other sources are left to link time.
bool is_for_the_linker(Diagnostic const &diagnostic) { return diagnostic.id == DiagnosticId::boundary_function; }

std::string real_path(Translation const &translation) { return fs::weakly_canonical(translation.source.name).string(); }

// The source as the rewriter and its own language's compiler read it.
rewrite::Compilation compilation(Translation const &translation, CommandLine const &line) {
  rewrite::Compilation source{translation.source.name, {}, line.flags};
  if (translation.source.language == Language::cxx) append(source.flags, {"-x", "c++"});
  if (translation.source.language == Language::c) append(source.flags, {"-x", "c"});
  return source;
}

std::optional<rewrite::Result> rewritten(Translation const &translation, CommandLine const &line) {
  rewrite::Request request;
  request.roots = translation.roots;
  request.exclude = translation.exclude;
  request.compilations = {compilation(translation, line)};
  request.defines = program::reference_defines();
  rewrite::Result result = rewrite::run(request);
  bool failed = false;
  for (Diagnostic const &diagnostic : result.diagnostics) {
    if (is_for_the_linker(diagnostic)) continue;
    print(std::cerr, diagnostic);
    failed |= diagnostic.severity == Severity::error;
  }
  if (failed) return {};
  std::string const real = real_path(translation);
  for (rewrite::File &file : result.files)
    if (file.path == real) file.text += link_marks(result);
  return result;
}

// Maps names of overlay files to the names that a compiler would report without the overlay.
class Names {
public:
  Names(rewrite::Result const &rewritten, std::string top) : rewritten_(rewritten), top_(std::move(top)) {}

  std::string original(std::string const &name) const {
    if (!name.starts_with(top_)) return name;
    std::string path = fs::path(name.substr(top_.size())).lexically_normal().string();
    for (rewrite::File const &file : rewritten_.files)
      if (file.path == path) return file.compiled_name;
    return path;
  }

  // The file, if it was rewritten but this name leads to the original.
  rewrite::File const *read_unchanged(std::string const &name) const {
    std::error_code error;
    std::string const real = fs::weakly_canonical(name, error).string(); // below top_ unless a link leads out of it
    for (rewrite::File const &file : rewritten_.files)
      if (file.path == real && file.text != file.original) return &file;
    return nullptr;
  }

  // Maps the names in line markers of a preprocessed text: # 12 "name" 2
  std::string line_markers(std::string const &text) const {
    std::string result;
    for (std::size_t begin = 0; begin < text.size();) {
      std::size_t const end = std::min(text.find('\n', begin), text.size() - 1) + 1;
      std::string_view const line(text.data() + begin, end - begin);
      std::size_t const open = line.starts_with("# ") ? line.find('"') : line.npos;
      std::size_t const close = open == line.npos ? line.npos : line.rfind('"');
      if (open != line.npos && line.substr(open + 1).starts_with(top_)) {
        std::string const name = original(std::string(line.substr(open + 1, close - open - 1)));
        result.append(line.substr(0, open)).append(in_quotes(name)).append(line.substr(close + 1));
      } else {
        result.append(line);
      }
      begin = end;
    }
    return result;
  }

private:
  rewrite::Result const &rewritten_;
  std::string const top_;
};

char const *option(Action action) {
  switch (action) {
  case Action::assembly: return "-S";
  case Action::preprocess: return "-E";
  case Action::check: return "-fsyntax-only";
  default: return "-c";
  }
}

bool succeeded(program::Captured const &done, Words const &words, Overlay const &overlay) {
  if (done.outcome.success()) {
    std::cerr << done.output;
    return true;
  }
  print(std::cerr, program::compiler_failure(words, done, overlay));
  return false;
}

// Reports headers that the compiler reads outside the overlay, which would mix the two modes.
bool all_rewritten(Words const &dependencies, Names const &names, std::string const &source) {
  for (std::string const &one : dependencies)
    if (rewrite::File const *file = names.read_unchanged(one)) {
      print(std::cerr,
            {DiagnosticId::read_unchanged,
             {source},
             "'" + file->display_path + "' is rewritten, but the compiler reads the original, as '" + one + "'"});
      return false;
    }
  return true;
}

// Writes in place, as compilers do, since `output` may be a device.
void deliver(std::string const &text, std::string const &output) {
  if (output.empty() || output == "-") {
    std::cout << text << std::flush;
    return;
  }
  std::ofstream file(output, std::ios::binary);
  file << text << std::flush;
  if (!file) fail(DiagnosticId::unwritable_output, {output}, "cannot write '" + output + "'");
}

Words compile_words(Translation const &translation, Words const &flags, std::string const &type_name) {
  Words words = translation.compiler;
  append(words, {"-isystem", runtime_include()});
  append(words, rewrite::type_name_flags(type_name));
  append(words, program::variant_flags(flags, program::Variant::symbolic));
  append(words, program::language_flags(flags, translation.source.language == Language::c, translation.compiler[0]));
  append(words, {"-frandom-seed=" + translation.source.name, option(translation.action)});
  return words;
}

bool compile(Translation const &translation, CommandLine const &line, rewrite::Result &result) {
  bool const keep = std::getenv("SYMREAL_KEEP") != nullptr;
  Workspace const workspace(keep);
  std::string const top = workspace.directory("overlay"), listed = workspace.file("dependencies");
  if (keep) std::cerr << "symreal: the rewritten sources are in " << top << "\n";
  program::CSources const c = program::as_in_c(result, {compilation(translation, line)}, translation.compiler,
                                               translation.compiler, result.type_name, workspace);
  Overlay const overlay(result, top, c.sources);
  Names const names(result, top);
  std::string const &source = translation.source.name;
  bool const preprocess = translation.action == Action::preprocess;
  std::string const output = preprocess ? workspace.file("preprocessed") : translation.output;
  Words words = compile_words(translation, overlay.search_flags(line.flags), result.type_name);
  if (auto const more = c.flags.find(real_path(translation)); more != c.flags.end()) append(words, more->second);
  append(words, {line.dependencies.wanted && !line.dependencies.system ? "-MMD" : "-MD", "-MF", listed, "-MT", "x"});
  append(words, {"-x", "c++", overlay.compiled_path(source)});
  if (translation.action != Action::check) append(words, {"-o", output});
  if (!succeeded(program::capture(program::compiler_run(words)), words, overlay)) return false;

  Words dependencies = program::read_make_rule(read_file(listed));
  if (!all_rewritten(dependencies, names, source)) return false;
  if (preprocess) deliver(names.line_markers(read_file(output)), translation.output);
  if (!line.dependencies.wanted) return true;
  for (std::string &name : dependencies) name = names.original(name);
  DependencyOptions const options = completed(line, source);
  auto const phony = options.phony ? program::Phony::all_but_first : program::Phony::none;
  deliver(program::make_rule(options.targets, dependencies, phony), options.file);
  return true;
}

void remove_output(Translation const &translation) {
  std::error_code ignored;
  if (fs::is_regular_file(translation.output, ignored)) fs::remove(translation.output, ignored);
}

// Does no output replace a file that is read?
bool is_apart(Translation const &translation, CommandLine const &line, Words const &read) {
  Words outputs = {translation.output};
  if (line.dependencies.wanted) outputs.push_back(completed(line, translation.source.name).file);
  for (std::string const &output : outputs)
    for (std::string const &one : read)
      if (fs::is_regular_file(output) && program::identity_of(output) == program::identity_of(one)) {
        print(std::cerr, {DiagnosticId::output_is_read,
                          {output},
                          "'" + one + "' is read, and '" + output + "' would take its place"});
        return false;
      }
  return true;
}

Words names_of(std::vector<Input> const &inputs) {
  Words names;
  for (Input const &one : inputs) names.push_back(one.name);
  return names;
}

} // namespace

bool translate(Translation const &translation, CommandLine const &line) {
  if (!is_apart(translation, line, names_of(line.inputs))) return false;
  try {
    auto result = rewritten(translation, line);
    if (result && !is_apart(translation, line, result->read)) return false;
    if (result && compile(translation, line, *result)) return true;
  } catch (DiagnosticError const &problem) {
    print(std::cerr, problem.diagnostic());
  }
  remove_output(translation);
  return false;
}

bool compile_preprocessed(Translation const &translation, CommandLine const &line) {
  Words words = translation.compiler;
  append(words, program::variant_flags(line.flags, program::Variant::symbolic));
  bool const is_c = translation.source.name.ends_with(".i");
  append(words, program::language_flags(line.flags, is_c, translation.compiler[0]));
  append(words, {"-frandom-seed=" + translation.source.name, option(translation.action)});
  append(words, {"-x", "c++-cpp-output", translation.source.name});
  if (!translation.output.empty()) append(words, {"-o", translation.output});
  if (succeeded(program::capture(program::compiler_run(words)), words, Overlay())) return true;
  remove_output(translation);
  return false;
}

bool is_symbolic(std::string const &preprocessed) {
  return preprocessed.find("namespace symreal") != std::string::npos;
}

} // namespace symreal::compiler
