#include "tool/commands/generate_options.h"

#include "tool/options/option_table.h"
#include "tool/output/outputs.h"

#include <algorithm>
#include <filesystem>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

bool calls_c(LanguageOption const &option) {
  std::vector<Language const *> const languages = option.languages();
  return std::ranges::find(languages, find_language("c")) != languages.end();
}

} // namespace

void GenerateOptions::add_to(CLI::App &command) {
  command.add_option("sources", source.project.request.sources,
                     "C and C++ sources of the program; with -p by default all of them");
  command.add_option("-o", output, "Output file, or directory for several kernels")->type_name("FILE");
  command.add_option("--graph", graph_file, "Also write the recorded graph as text")->type_name("FILE");
  command.add_option("--dump", dump, "Also write these stages as text beside the output: optimised, plan")
      ->type_name("STAGES")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"optimised", "plan"}));
  command.add_option("--depfile", depfile, "Also write the dependencies of the result as a make rule")
      ->type_name("FILE");
  command.add_flag("--check", check, "Write nothing; check whether the existing files are up to date");
  language.add_to(command, "c");
  bundle.add_to(command);
  differentiate.add_to(command);
  differentiate.add_separate_to(command);
  passes.add_to(command);
  emitter.add_to(command);
  parallel.add_to(command);
  reroll.add_to(command);
  vector.add_to(command);
  command.add_flag("--wrapper", wrapper, "Also emit a file that defines the function in place of the original");
  decisions.add_to(command);
  command
      .add_option("--record", recorded,
                  "Record the rewritten source, or the instructions that clang 19 emits for the original")
      ->type_name("source|instructions")
      ->check(CLI::IsMember({"source", "instructions"}));
  frozen.add_to(command);
  source.add_to(command);
  command.add_flag("--write-config", write_config, "Add the clauses that a pragma lacks to .symreal.yaml");
  command.add_flag("--stats", statistics, "Print detailed statistics: every object, every pass");
  command.add_flag("--json", json, "Print the table as JSON to standard output");
}

void GenerateOptions::require_sense(CLI::App const &command) const {
  require_compatible(command);
  bundle.require_sense();
  require_one_language(language.languages(), emitter);
  if (wrapper && !calls_c(language))
    fail(DiagnosticId::option_without_effect, {}, "--wrapper calls generated C: name c among the languages of --lang");
  if (wrapper && emitter.is_single())
    fail(DiagnosticId::bad_option, {}, "--wrapper hands on doubles: leave --real=float out");
  if (wrapper && differentiate.is_given() && !differentiate.separate)
    fail(DiagnosticId::bad_option, {}, no_derivatives_in_wrapper);
  (void)emitter.is_single();
  frozen.require_sense();
  decisions.require_sense();
  if (records_instructions() && decisions.of_recording() == "select")
    fail(DiagnosticId::bad_option, {},
         "--decisions=select is about the rewritten text, and --record=instructions rewrites nothing: take guard or "
         "explore");
  (void)passes.settings();
  (void)passes.names();
}

void GenerateOptions::require_outputs() const {
  // If there are several kernels, known only later, these may be directories still to be created.
  auto may_be_file = [](std::string const &path) { return !path.empty() && !names_directory(path); };
  if (check) return;
  if (may_be_file(output) && fs::path(output).has_extension()) require_source_name(output, language.languages());
  std::vector<std::string> paths = {emitter.map_file, depfile};
  for (std::string const *one : {&output, &graph_file, &bundle.unit})
    if (may_be_file(*one)) paths.push_back(*one);
  require_writable(paths);
}

} // namespace symreal::tool
