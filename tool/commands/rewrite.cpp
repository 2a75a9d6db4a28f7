#include "rewrite/rewrite.h"
#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/read_files.h"
#include "program/build/tree_edit.h"
#include "rewrite/text/exports.h"
#include "tool/commands/subcommands.h"
#include "tool/options/source_options.h"
#include "tool/output/outputs.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

struct Options {
  ProjectOptions project;
  bool diff = false, in_place = false;
  std::string out_root, fixes;
};

std::string words(std::vector<std::string> const &flags) {
  std::string text;
  for (std::string const &flag : flags) text += " " + flag;
  return text;
}

void edit_in_place(rewrite::Result const &result) {
  std::vector<program::Replacement> replacements;
  for (rewrite::File const &file : result.files)
    if (file.original != file.text) replacements.push_back({file.path, file.original, file.text});
  std::string const directory = program::edit_tree(replacements);
  std::cerr << replacements.size() << " files rewritten";
  if (!replacements.empty())
    std::cerr << "; compile them with" << words(rewrite::type_name_flags(result.type_name))
              << "; undo it with: symreal undo " << directory;
  std::cerr << "\n";
}

bool is_below(std::string const &path, fs::path const &directory) {
  return path.starts_with((directory / "").string());
}

// Top of the mirror in the user's tree: the --root that contains all files, else their deepest common directory.
std::string top_of(std::vector<rewrite::File> const &files, std::vector<std::string> const &roots) {
  for (std::string const &root : roots) {
    std::error_code error;
    fs::path const real = fs::canonical(root, error);
    if (!error &&
        std::all_of(files.begin(), files.end(), [&](rewrite::File const &file) { return is_below(file.path, real); }))
      return real.string();
  }
  return {};
}

void write_mirror(std::vector<rewrite::File> const &files, std::string const &directory, std::string const &top) {
  Outputs outputs;
  for (auto &[path, text] : rewrite::mirror(files, directory, top)) {
    outputs.directories.push_back(fs::path(path).parent_path().string());
    outputs.files.push_back({path, std::move(text)});
  }
  write_outputs(outputs);
}

// Does this error leave a text to show? Not if it concerns a whole file: conflicting rewrites by two sources, or a
// pragma that cannot be parsed.
bool leaves_a_text(Diagnostic const &one) {
  bool const is_of_a_place = one.id >= DiagnosticId::boundary_function && one.id <= DiagnosticId::unaccounted_double;
  return is_of_a_place || one.id == DiagnosticId::source_error || one.id == DiagnosticId::class_layout ||
         one.id == DiagnosticId::evaluation_order;
}

// Prints the diagnostics; the status says how far the rewriting goes.
Status report(rewrite::Result const &result) {
  Status status = result.left_out.empty() ? clean : partly_skipped;
  for (Diagnostic const &diagnostic : result.diagnostics) {
    print(std::cerr, diagnostic);
    if (diagnostic.severity == Severity::error && status != error)
      status = leaves_a_text(diagnostic) ? partly_skipped : error;
  }
  for (std::string const &source : result.left_out) std::cerr << "left out, does not compile: " << source << "\n";
  return result.files.empty() && status != clean ? error : status;
}

void run(CLI::App &command, Options &options, Session &session) {
  options.project.configure(command, session.configured);
  if (options.diff + options.in_place + !options.out_root.empty() + !options.fixes.empty() != 1)
    fail(DiagnosticId::bad_option, {}, "choose one of --diff, --out-root, --in-place and --export-fixes");
  // A preview shows as much as could be rewritten.
  bool const only_shows = options.diff || !options.out_root.empty();
  rewrite::Request request = only_rewritten(options.project.complete(session.flags));
  request.leave_out_broken = only_shows;
  rewrite::Result const result = rewrite::run(request);
  for (std::string const &file : result.read) program::note_read(file);
  session.status = report(result);
  if (session.status != clean && !only_shows) session.status = error;
  if (session.status == error) return;
  if (!options.out_root.empty())
    write_mirror(result.files, options.out_root, top_of(result.files, request.roots));
  else if (!options.fixes.empty())
    write_outputs({{{options.fixes, rewrite::fixes_yaml(result.files)}}});
  else if (options.in_place)
    edit_in_place(result);
  else
    for (rewrite::File const &file : result.files)
      std::cout << unified_diff(file.display_path, file.original, file.text);
}

} // namespace

void add_rewrite(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("rewrite", "Show or write the sources in their symbolic form");
  auto options = std::make_shared<Options>();
  options->project.add_to(*command);
  command->add_flag("--diff", options->diff, "Print a unified diff");
  command->add_option("--out-root", options->out_root, "Write a mirror of the files below this directory")
      ->type_name("DIR");
  command->add_flag("--in-place", options->in_place,
                    "Replace the files, all of them or none; symreal undo restores them");
  command->add_option("--export-fixes", options->fixes, "Write the edits as YAML for clang-apply-replacements")
      ->type_name("FILE");
  command->callback([options, command, &session] { run(*command, *options, session); });
}

} // namespace symreal::tool
