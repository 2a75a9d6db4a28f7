#include "tool/output/wrapper.h"

#include "engine/graph/names.h"
#include "engine/support/files.h"
#include "engine/support/parallel.h"
#include "engine/support/text.h"
#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapper_text.h"
#include "tool/output/replacement_text.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <regex>
#include <set>
#include <string>
#include <thread>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

// A file of the program, and its copy.
struct Copy {
  rewrite::File const *file;
  std::string path;
};

Copy const *copy_of(std::vector<Copy> const &copies, std::string const &file) {
  auto const found = std::ranges::find_if(copies, [&](Copy const &one) { return one.file->path == file; });
  return found == copies.end() ? nullptr : &*found;
}

// Path of a header beside the including file; empty if it is found elsewhere.
std::string beside(rewrite::File const &file, std::string const &name) {
  std::error_code error;
  fs::path const path = fs::path(file.path).parent_path() / name;
  return fs::is_regular_file(path, error) ? fs::weakly_canonical(path, error).string() : "";
}

std::regex const &inclusions() {
  static std::regex const pattern(
      "((?:^|\\n)[ \\t]*#[ \\t]*include[ \\t]*|__has_include[ \\t]*\\([ \\t]*)\"([^\"\\n]*)\"");
  return pattern;
}

// Rewrites inclusions of neighbouring headers for the copy's location.
std::string with_inclusions(std::string const &text, Copy const &copy, std::vector<Copy> const &copies) {
  std::string result;
  std::size_t begin = 0;
  for (std::sregex_iterator one(text.begin(), text.end(), inclusions()), end; one != end; ++one) {
    std::string const header = beside(*copy.file, one->str(2));
    if (header.empty()) continue;
    Copy const *copied = copy_of(copies, header);
    auto const at = static_cast<std::size_t>(one->position(2));
    result += text.substr(begin, at - begin) +
              path_from(fs::path(copy.path).parent_path(), copied ? real_path(copied->path) : fs::path(header));
    begin = at + static_cast<std::size_t>(one->length(2));
  }
  return result + text.substr(begin);
}

bool is_source(program::Front const &front, std::string const &file) {
  return std::ranges::any_of(front.build.sources, [&](auto const &one) { return rewrite::real_source(one) == file; });
}

// Files to copy: the function's own; for a header, also the files that include it from beside themselves, transitively.
std::set<std::string> copied_with(program::Front const &front, std::string const &file) {
  std::set<std::string> copied = {file};
  for (bool grows = !is_source(front, file); grows;) {
    grows = false;
    for (rewrite::File const &one : front.rewritten.files)
      for (std::sregex_iterator each(one.original.begin(), one.original.end(), inclusions()), end; each != end; ++each)
        if (copied.contains(beside(one, each->str(2)))) grows |= copied.insert(one.path).second;
  }
  return copied;
}

bool is_within(fs::path const &file, fs::path const &directory) {
  fs::path const inside = file.lexically_relative(directory);
  return !inside.empty() && *inside.begin() != "..";
}

// Directory below which the copies mirror the files. A header found in a search directory keeps its name.
fs::path root_of(program::Front const &front, std::set<std::string> const &files) {
  fs::path root = fs::path(*files.begin()).parent_path();
  if (files.size() == 1)
    for (std::string const &one : front.rewritten.include_dirs)
      if (is_within(*files.begin(), real_path(one))) root = real_path(one);
  while (std::ranges::any_of(files, [&](std::string const &one) { return !is_within(one, root); }))
    root = root.parent_path();
  return root;
}

// The flag for C99 or C++11, which wrappers need, if the flags select an older standard; else empty.
std::string later_standard(std::vector<std::string> const &flags, bool c) {
  std::string standard;
  for (std::string const &flag : flags)
    if (flag == "-ansi" || flag.starts_with("-std=")) standard = flag;
  for (char const *const year : {"ansi", "89", "90", "199409", "98", "03"})
    if (standard.ends_with(year)) return c ? "-std=gnu99" : "-std=gnu++11";
  return "";
}

// First error of the compiler under the original's flags; empty on success.
std::string compiler_objection(program::Front const &front, rewrite::Kernel const &kernel, std::string const &source,
                               std::vector<OutputFile> const &files, OutputFile const *main) {
  auto const compiled =
      std::ranges::find_if(front.build.sources, [&](auto const &one) { return rewrite::real_source(one) == source; });
  if (compiled == front.build.sources.end()) return {};
  std::string const directory = front.workspace->directory("wrapper-" + identifier(kernel.name));
  std::vector<std::string> searched;
  std::string path = source;
  for (OutputFile const &one : files) {
    std::error_code error;
    fs::path const place = real_path(one.path);
    fs::path const tried = fs::path(directory) / place.relative_path();
    fs::create_directories(tried.parent_path(), error);
    write_if_changed(tried.string(), one.text);
    searched.insert(searched.end(), {"-iquote", place.parent_path().string()});
    if (main == &one) path = tried.string();
    if (!main) searched.insert(searched.begin(), {"-I", tried.parent_path().string()});
  }
  bool const c = program::is_c(*compiled);
  std::vector<std::string> words = {c ? front.build.c_compiler : front.build.compiler};
  words.insert(words.end(), searched.begin(), searched.end());
  std::vector<std::string> const flags = program::unchanged_flags(compiled->flags);
  words.insert(words.end(), flags.begin(), flags.end());
  if (std::string const standard = later_standard(flags, c); !standard.empty()) words.push_back(standard);
  for (std::string const &one : {"-w", "-x", c ? "c" : "c++", "-c", path.c_str(), "-o"}) words.push_back(one);
  words.push_back(directory + "/wrapper.o");
  program::Captured const result = program::capture(program::compiler_run(words, compiled->directory));
  if (result.outcome.success()) return {};
  std::size_t const at = result.output.find("error: ");
  return at == result.output.npos ? result.output : result.output.substr(at + 7, result.output.find('\n', at) - at - 7);
}

} // namespace

void Wrappers::add(program::Recorded const &recorded, Graph const &graph, EmitterOptions const &options,
                   std::string const &generated) {
  rewrite::Kernel const &kernel = recorded.kernel;
  require_replaceable(kernel);
  if (!graph.guards.empty() && !recorded.scratch.empty())
    fail(DiagnosticId::no_wrapper, kernel.place,
         fmt::format("--wrapper cannot take the place of '{}': where a guard does not hold the original is called, and "
                     "may read '{}', which generated code does not write",
                     kernel.name, recorded.scratch.front()));
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  std::string const prefix = options.prefix.empty() ? "" : options.prefix + "_";
  fs::path const directory = fs::path(generated).parent_path();
  fs::path const wrapper = directory / (fs::path(generated).stem().string() + "_wrapper");
  std::string why = function.obstacle;
  if (why.empty() && !function.missing.empty())
    why = fmt::format("only {} has {}", kernel.source, fmt::join(function.missing, ", "));
  std::vector<OutputFile> own;
  if (why.empty()) {
    std::string const suffix = fs::path(kernel.source).extension() == ".c" ? ".c" : ".cpp";
    own = {{wrapper.string() + suffix, own_file(recorded, graph, prefix, directory)}};
  }
  std::vector<std::string> blocks = preamble(recorded, graph, prefix);
  blocks.insert(blocks.begin(), c_declarations(graph, prefix));
  replaced_.push_back({kernel, wrapper.string(), std::move(own), why, copied_with(front_, function.file),
                       program::compares_classes(recorded), std::move(blocks),
                       try_statements(recorded, graph, prefix)});
}

// Compiles the files of their own, except those of functions that are in a copy anyway.
void Wrappers::try_own() {
  std::set<std::size_t> copied;
  for (Group const &group : groups()) copied.insert(group.begin(), group.end());
  in_parallel(replaced_.size(), std::thread::hardware_concurrency(), [&](std::size_t k) {
    Replaced &one = replaced_[k];
    if (copied.contains(k)) return;
    std::string const objection =
        compiler_objection(front_, one.kernel, one.kernel.signature.redefinition.file, one.own, &one.own.front());
    if (!objection.empty()) one.why = "a file of its own does not compile: " + objection;
  });
}

// Files to copy for the functions of the group.
std::set<std::string> Wrappers::copied_for(Group const &group) const {
  std::set<std::string> all;
  for (std::size_t const k : group) all.insert(replaced_[k].copied.begin(), replaced_[k].copied.end());
  return all;
}

// The functions that are replaced in copies, by the files that these have in common.
std::vector<Wrappers::Group> Wrappers::groups() const {
  std::vector<Group> all;
  auto const is_grouped = [&](std::size_t k) {
    return std::ranges::any_of(all, [&](Group const &group) { return std::ranges::find(group, k) != group.end(); });
  };
  auto const join = [&](std::size_t k) { // with all groups that have a file of it
    std::set<std::string> const files = copied_for({k});
    Group joined = {k};
    std::erase_if(all, [&](Group const &group) {
      std::set<std::string> const others = copied_for(group);
      if (std::ranges::none_of(files, [&](std::string const &file) { return others.contains(file); })) return false;
      joined.insert(joined.end(), group.begin(), group.end());
      return true;
    });
    std::ranges::sort(joined);
    all.push_back(joined);
  };
  for (std::size_t k = 0; k < replaced_.size(); ++k)
    if (!replaced_[k].why.empty()) join(k);
  for (bool grows = true; grows;) {
    grows = false;
    std::set<std::string> copied;
    for (Group const &group : all) copied.merge(copied_for(group));
    for (std::size_t k = 0; k < replaced_.size(); ++k)
      if (!is_grouped(k) && copied.contains(replaced_[k].kernel.signature.redefinition.file)) join(k), grows = true;
  }
  std::ranges::sort(all);
  return all;
}

// Blocks before the text of a copy. Functions of several copies in one translation unit may need the same ones.
std::string Wrappers::top_of(Group const &here) const {
  bool const in_header = std::ranges::any_of(
      replaced_, [&](Replaced const &one) { return !is_source(front_, one.kernel.signature.redefinition.file); });
  std::vector<std::string> known; // of the run
  for (Replaced const &one : replaced_)
    for (std::string const &block : one.blocks)
      if (std::ranges::find(known, block) == known.end()) known.push_back(block);
  std::string top;
  std::vector<std::string> blocks;
  for (std::size_t const k : here) {
    if (replaced_[k].with_classes && top.empty()) top = "#include <typeinfo>\n";
    for (std::string const &block : replaced_[k].blocks)
      if (std::ranges::find(blocks, block) == blocks.end()) blocks.push_back(block);
  }
  for (std::string const &block : blocks)
    top += !in_header || replaced_.size() == 1
               ? block
               : program::once(
                     fmt::format("SYMREAL_COPY_BLOCK_{}", std::ranges::find(known, block) - known.begin() + 1), block);
  // Adds an include guard, as a header may be included repeatedly.
  if (in_header && replaced_.size() == 1)
    top = program::once("SYMREAL_COPY_WITH_" + identifier(replaced_[here.front()].kernel.name), top);
  return top;
}

std::vector<OutputFile> Wrappers::copies_for(Group const &group, Copies &made) const {
  std::set<std::string> const copied = copied_for(group);
  fs::path const root = root_of(front_, copied), wrapper = replaced_[group.front()].wrapper;
  made.is_one_source = copied.size() == 1 && is_source(front_, *copied.begin());
  std::vector<Copy> copies;
  for (rewrite::File const &one : front_.rewritten.files)
    if (copied.contains(one.path))
      copies.push_back({&one, made.is_one_source ? wrapper.string() + fs::path(one.path).extension().string()
                                                 : (wrapper / fs::path(one.path).lexically_relative(root)).string()});
  std::vector<OutputFile> files;
  for (Copy const &copy : copies) {
    std::string const name = in_quotes(copy.file->display_path), &text = copy.file->original;
    Group here;
    for (std::size_t const k : group)
      if (replaced_[k].kernel.signature.redefinition.file == copy.file->path) here.push_back(k);
    auto const body = [&](std::size_t k) { return replaced_[k].kernel.signature.redefinition.body; };
    std::ranges::sort(here, {}, body);
    std::string what = "which includes other copies", top, before;
    if (!here.empty()) top = top_of(here);
    std::vector<std::string> functions;
    std::size_t begin = 0;
    for (std::size_t const k : here) {
      functions.push_back(replaced_[k].kernel.signature.redefinition.qualified);
      auto const lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(body(k)), '\n');
      before += with_inclusions(text.substr(begin, body(k) - begin), copy, copies) + "\n" + replaced_[k].statements +
                fmt::format("#line {} {}\n", lines + 1, name);
      begin = body(k);
    }
    if (!here.empty())
      what = fmt::format("in which generated code stands before the {} of {}", here.size() == 1 ? "body" : "bodies",
                         fmt::join(functions, ", "));
    files.push_back({copy.path, fmt::format("/* Generated by Symreal: a copy of {}, {}. */\n{}#line 1 {}\n",
                                            fs::path(copy.file->path).filename().string(), what, top, name) +
                                    before + with_inclusions(text.substr(begin), copy, copies)});
    if (is_source(front_, copy.file->path)) {
      made.sources += (made.sources.empty() ? "" : ", ") + copy.file->display_path;
      made.compiled.emplace_back(files.size() - 1, copy.file->path);
    }
  }
  return files;
}

// First error of the compiler in the group's copies; empty on success.
std::string Wrappers::objection_to(Group const &group) const {
  Copies made;
  std::vector<OutputFile> const files = copies_for(group, made);
  rewrite::Kernel const &kernel = replaced_[group.front()].kernel;
  std::string objection;
  for (auto const &[k, source] : made.compiled)
    if (objection.empty()) objection = compiler_objection(front_, kernel, source, files, &files[k]);
  if (made.compiled.empty())
    objection = compiler_objection(front_, kernel, rewrite::real_source(front_.build.sources.front()), files, nullptr);
  return objection;
}

// Tells what to do with the group's copies, or why they are refused.
void Wrappers::tell(Group const &group, Copies const &made, std::vector<OutputFile> const &files,
                    std::vector<Diagnostic> &told) const {
  std::string const objection = objection_to(group);
  auto const refuse = [&](std::size_t k, std::string const &why) {
    rewrite::Kernel const &kernel = replaced_[k].kernel;
    told.push_back({DiagnosticId::no_wrapper, kernel.place,
                    fmt::format("the wrapper of '{}' does not compile: {}", kernel.name, why)});
  };
  std::size_t const told_before = told.size();
  if (!objection.empty() && group.size() > 1)
    for (std::size_t const k : group)
      if (std::string const why = objection_to({k}); !why.empty()) refuse(k, why);
  if (!objection.empty() && told.size() == told_before) refuse(group.front(), objection);
  if (!objection.empty()) return;
  std::string const wrapper = replaced_[group.front()].wrapper;
  std::string const way =
      made.is_one_source     ? fmt::format("compile {} in place of {}", files.front().path, made.sources)
      : made.sources.empty() ? fmt::format("search {} before other directories", wrapper)
                             : fmt::format("compile the copies in {} in place of {}", wrapper, made.sources);
  auto const needing = std::ranges::find_if(group, [&](std::size_t k) { return !replaced_[k].why.empty(); });
  for (std::size_t const k : group) {
    Replaced const &one = replaced_[k];
    std::string const why = one.why.empty() ? fmt::format("'{}' needs one", replaced_[*needing].kernel.name) : one.why;
    told.push_back({DiagnosticId::wrapper_needs_source,
                    one.kernel.place,
                    fmt::format("the wrapper of '{}' is a copy of its file, since {}: {}", one.kernel.name, why, way),
                    {},
                    Severity::remark});
  }
}

std::vector<std::vector<OutputFile>> Wrappers::files(std::vector<Diagnostic> &told) {
  try_own();
  std::vector<std::vector<OutputFile>> all;
  for (Replaced const &one : replaced_) all.push_back(one.own);
  for (Group const &group : groups()) {
    for (std::size_t const k : group) all[k].clear();
    Copies made;
    all[group.front()] = copies_for(group, made);
    tell(group, made, all[group.front()], told);
  }
  return all;
}

} // namespace symreal::tool
