#include "program/build/compile.h"

#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "engine/support/parallel.h"
#include "engine/support/progress.h"
#include "program/build/bounded_compilation.h"
#include "program/build/c_macros.h"
#include "program/build/compiler_messages.h"
#include "program/build/read_files.h"
#include "program/build/runtime_header.h"
#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <llvm/Support/Program.h>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace symreal::program {

using rewrite::About;
using rewrite::DriverOption;

namespace {

bool is_rewritten(Variant variant) { return variant == Variant::symbolic || variant == Variant::replay; }
std::string_view name(Variant variant) {
  switch (variant) {
  case Variant::symbolic: return "symbolic";
  case Variant::replay: return "replay";
  case Variant::original: return "original";
  case Variant::own_flags: return "own-flags";
  case Variant::wrapped: return "wrapped";
  case Variant::covered: return "covered";
  case Variant::recorded: return "recorded";
  }
  return "";
}

using Words = std::vector<std::string>;

// Counters must be in memory whenever the kernel begins or ends, and each source function must exist in the program.
Words const coverage_flags = {"-fprofile-instr-generate", "-fcoverage-mapping", "-mllvm", "-do-counter-promotion=false",
                              "-fno-inline"};

} // namespace

Command compiler_run(Words words, std::string const &directory) {
  return {.arguments = std::move(words), .directory = directory, .environment = {"LC_ALL=C", "GCC_COLORS="}};
}

namespace {

// Puts each function and variable into its own section, so that the linker can drop it.
void cut_up(BuildRequest const &request, Words &words) {
  if (request.reachable) append(words, {"-ffunction-sections", "-fdata-sections"});
}

} // namespace

Words rewritten_compilation(BuildRequest const &request, Variant variant, Overlay const &overlay,
                            rewrite::Compilation const &source, std::string const &object) {
  Words words = {request.compiler};
  append(words, rewrite::type_name_flags(request.type_name)); // headers that the flags include are rewritten, too
  append(words, overlay.search_flags(variant_flags(source.flags, variant), source.directory));
  append(words, language_flags(source.flags, is_c(source), request.compiler));
  if (is_c(source) && is_before_c99(source.flags)) words.emplace_back("-DSYMREAL_BEFORE_C99");
  append(words, {"-I", runtime_include()});
  if (auto const more = request.source_flags.find(rewrite::real_source(source)); more != request.source_flags.end())
    append(words, more->second);
  cut_up(request, words);
  append(words, {"-x", "c++", "-c", overlay.compiled_path(rewrite::real_source(source)), "-o", object});
  return words;
}

namespace {

Words original_command(BuildRequest const &request, Variant variant, Overlay const &overlay,
                       rewrite::Compilation const &source, std::string const &object) {
  bool const c = is_c(source), is_recorded = variant == Variant::recorded, is_covered = variant == Variant::covered;
  Words words = {is_recorded || is_covered ? clang_compiler : c ? request.c_compiler : request.compiler};
  append(words, {"-include", runtime_include() + "/symreal/original.h"});
  if (is_recorded) append(words, {"-fpass-plugin=" + recording_plugin(), "-fno-discard-value-names"});
  Words flags = original_flags(source.flags, variant);
  if (variant == Variant::own_flags)
    flags.emplace_back("-DSYMREAL_OWN_FLAGS");
  else
    append_reference(flags);
  if (is_covered) append(flags, coverage_flags);
  append(words, overlay.search_flags(flags, source.directory));
  if (c) append(words, {"-Dregister="}); // annotations take addresses, which `register` forbids
  cut_up(request, words);
  append(words, {"-w", "-x", c ? "c" : "c++", "-c"});
  append(words, {overlay.compiled_path(rewrite::real_source(source)), "-o", object});
  return words;
}

Words unchanged_command(BuildRequest const &request, rewrite::Compilation const &source, std::string const &object) {
  Words words = {is_c(source) ? request.c_compiler : request.compiler};
  append(words, unchanged_flags(source.flags));
  cut_up(request, words);
  append(words, {"-w", "-x", is_c(source) ? "c" : "c++", "-c", source.source, "-o", object});
  return words;
}

// Does the compiler flag also concern the linker (-l, -L, -Wl, ...)?
bool is_for_linker(DriverOption const &option) {
  return option.about == About::linking || option.about == About::openmp || option.about == About::sanitizers;
}

// Compiler flags of all sources that the linker needs, without duplicates.
Words linker_flags(BuildRequest const &request) {
  Words words;
  std::set<std::string> known;
  for (auto const *sources : {&request.sources, &request.unchanged})
    for (rewrite::Compilation const &source : *sources)
      for (DriverOption const &option : rewrite::driver_options(source.flags))
        if (is_for_linker(option) && known.insert(option.name + " " + option.value).second)
          rewrite::append(words, option, source.flags);
  append(words, request.link);
  return words;
}

Words link_command(BuildRequest const &request, Variant variant, Words const &objects, std::string const &executable) {
  Words words = {request.compiler};
  if (variant == Variant::covered) words = {clang_compiler, "--driver-mode=g++", "-fprofile-instr-generate"};
  Words const own = linker_flags(request);
  if (variant != Variant::replay && !brings_allocator(own)) words.emplace_back("-Wl,-u,symreal_heap_hooks");
  if (variant == Variant::original || variant == Variant::wrapped ||
      variant == Variant::covered) { // generated code that it loads calls its functions
    if (!request.reachable)
      words.emplace_back("-rdynamic");
    else
      for (std::string const &one : request.called_from_outside) words.push_back("-Wl,--export-dynamic-symbol=" + one);
  }
  if (request.reachable) words.emplace_back("-Wl,--gc-sections");
  append(words, objects);
  append(words, own);
  append(words, {runtime_library(), "-o", executable});
  return words;
}

template <class Run> std::vector<Captured> run_all(std::vector<Command> const &commands, Run run) {
  std::vector<Captured> results(commands.size());
  Progress progress("objects", commands.size());
  in_parallel(commands.size(), std::thread::hardware_concurrency(), [&](std::size_t k) {
    results[k] = run(k);
    progress.add();
  });
  return results;
}

// Switches optimisation off and makes each operation on numbers a plain call, without the inline test for recording.
Words without_optimisation(Words words) {
  std::ranges::replace(words, "-O1", "-O0");
  words.insert(words.begin() + 1, "-DSYMREAL_CALLED_OPERATORS");
  return words;
}

// Command that compiles the source unchanged.
Words plain_command(BuildRequest const &request, rewrite::Compilation const &source, std::string const &object) {
  Words words = {is_c(source) ? request.c_compiler : request.compiler};
  append(words, c_flags(source.flags));
  append(words, {"-w", "-x", is_c(source) ? "c" : "c++", "-c", source.source, "-o", object});
  return words;
}

BoundedCompilation bounded(BuildRequest const &request, rewrite::Compilation const &source, Command const &usual) {
  std::error_code error;
  std::uintmax_t const size = std::filesystem::file_size(rewrite::real_source(source), error);
  auto const read = request.reading_seconds.find(rewrite::real_source(source));
  BoundedCompilation all{usual,
                         usual,
                         {},
                         source.source,
                         !error && size >= large_source,
                         read == request.reading_seconds.end() ? 0 : read->second};
  all.unoptimised.arguments = without_optimisation(usual.arguments);
  std::string const &object = usual.arguments[position_after(usual.arguments, "-o")];
  all.original = compiler_run(plain_command(request, source, object + ".original"), source.directory);
  return all;
}

// Cache key: hash of everything that affects the compilation time.
std::string bounded_key(Command const &command, std::string const &workspace) {
  std::string text = "bounded " + read_file(command.arguments[position_after(command.arguments, "-c")]);
  for (std::string const &word : command.arguments)
    if (word.find(workspace) == word.npos) text += '\0' + word;
  return rewrite::content_id(text);
}

// Notes a compiler, or a wrapper around one, as read.
void note_program(std::string const &name) {
  if (auto const path = llvm::sys::findProgramByName(name)) note_read(*path);
}

// Notes files and libraries among the linker's arguments as read.
void note_linked(Words const &words) {
  Words directories;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string_view word = words[i];
    bool const is_directory = word.starts_with("-L"), is_library = word.starts_with("-l");
    std::string value((is_directory || is_library) && word.size() > 2 ? word.substr(2) : "");
    if ((is_directory || is_library) && value.empty() && i + 1 < words.size()) value = words[++i];
    if (is_directory)
      directories.push_back(value);
    else if (is_library)
      for (std::string const &directory : directories)
        for (char const *ending : {".so", ".a"})
          if (std::string const path = directory + "/lib" + value + ending; std::filesystem::is_regular_file(path))
            note_read(path);
    if (!word.starts_with('-') && std::filesystem::is_regular_file(word)) note_read(words[i]);
  }
}

} // namespace

std::vector<std::string> build_variants(BuildRequest const &request, std::span<Variant const> variants,
                                        Overlay const &rewritten, Overlay const &annotated,
                                        Workspace const &workspace) {
  std::vector<Command> compilations, links;
  std::vector<std::string> executables;
  Words unchanged;
  for (rewrite::Compilation const &source : request.unchanged) {
    unchanged.push_back(workspace.file("unchanged_" + std::to_string(unchanged.size()) + ".o"));
    compilations.push_back(compiler_run(unchanged_command(request, source, unchanged.back()), source.directory));
  }
  for (Variant variant : variants) {
    std::string directory = workspace.directory(std::string(name(variant)));
    Words objects;
    for (rewrite::Compilation const &source : request.sources) {
      objects.push_back(directory + "/" + std::to_string(objects.size()) + ".o");
      Words const command = is_rewritten(variant)
                                ? rewritten_compilation(request, variant, rewritten, source, objects.back())
                                : original_command(request, variant, annotated, source, objects.back());
      compilations.push_back(compiler_run(command, source.directory));
    }
    append(objects, unchanged);
    executables.push_back(directory + "/program");
    links.push_back(compiler_run(link_command(request, variant, objects, executables.back()), {}));
  }

  for (auto const *commands : {&compilations, &links})
    for (Command const &command : *commands) note_program(command.arguments.front());
  note_linked(linker_flags(request));

  FilesNow files;
  RuntimeHeader header(*request.cache, request.cache->directory(), workspace.path());
  auto const with_header = [&](Command const &compilation) { return header.use(compilation, files); };
  auto const compile = [&](Command const &compilation) {
    return request.cache->compile(compilation, workspace.path(), files, with_header);
  };
  std::mutex telling;
  auto const tell = [&](std::string const &text) {
    std::scoped_lock const lock(telling);
    request.note(text);
  };
  std::vector<Captured> compiled = run_all(compilations, [&](std::size_t k) {
    std::size_t const place = k - request.unchanged.size();
    if (k < request.unchanged.size() || variants[place / request.sources.size()] != Variant::symbolic)
      return compile(compilations[k]);
    CacheDirectory &kept = request.cache->directory();
    return compile_bounded(
        bounded(request, request.sources[place % request.sources.size()], compilations[k]),
        {compile, capture, tell, kept.exists() ? &kept : nullptr, bounded_key(compilations[k], workspace.path())});
  });
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    if (compiled[i].outcome.success()) continue;
    bool const as_rewritten =
        i < request.unchanged.size() || is_rewritten(variants[(i - request.unchanged.size()) / request.sources.size()]);
    throw DiagnosticError(as_rewritten ? compiler_failure(compilations[i].arguments, compiled[i], rewritten)
                                       : compiler_failure(compilations[i].arguments, compiled[i], annotated,
                                                          "as the original with its annotations"));
  }
  Linking linking(request.cache->directory(), workspace.path(), files, linker_flags(request).empty());
  std::vector<Captured> linked = run_all(links, [&](std::size_t k) { return linking.link(links[k]); });
  for (std::size_t i = 0; i < linked.size(); ++i)
    if (!linked[i].outcome.success()) throw DiagnosticError(linker_failure(links[i].arguments, linked[i], rewritten));
  return executables;
}

std::vector<Diagnostic> symbolic_check(BuildRequest request, rewrite::Result rewritten) {
  for (rewrite::File &file : rewritten.files) file.compiled_name = file.display_path;
  Workspace const workspace(false);
  request.type_name = rewritten.type_name;
  CSources c =
      as_in_c(rewritten, request.sources, {request.compiler}, {request.c_compiler}, request.type_name, workspace);
  request.source_flags = std::move(c.flags);
  Overlay const overlay(rewritten, workspace.directory("overlay"), std::move(c.sources));

  std::vector<std::optional<Diagnostic>> found(request.sources.size());
  in_parallel(found.size(), std::thread::hardware_concurrency(), [&](std::size_t k) {
    rewrite::Compilation const &source = request.sources[k];
    std::vector<std::string> words = rewritten_compilation(request, Variant::symbolic, overlay, source, "/dev/null");
    std::replace(words.begin(), words.end(), std::string("-c"), std::string("-fsyntax-only"));
    Captured const result = capture(compiler_run(words, source.directory));
    if (!result.outcome.success()) found[k] = compiler_failure(words, result, overlay);
  });
  std::vector<Diagnostic> diagnostics;
  for (std::optional<Diagnostic> &one : found)
    if (one) diagnostics.push_back(std::move(*one));
  return diagnostics;
}

} // namespace symreal::program
