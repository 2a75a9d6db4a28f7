#include "tool/verify_numeric.h"

#include "diagnostics/diagnostic.h"
#include "program/numeric_identity.h"

#include <iostream>
#include <set>

namespace symreal::tool {

void NumericOptions::add_to(CLI::App &app) {
  app.add_flag("--numeric", enabled,
               "Instead compare the object code of all sources before and after the rewriting, without the switch");
  app.add_option("--cc", c_compiler,
                 "Compiler of sources that end in .c; by default cc, with --numeric that of their build");
}

int verify_numeric(CLI::App const &command, NumericOptions const &options, ProjectOptions const &project,
                   std::string const &cxx_compiler, Session const &session) {
  static std::set<std::string> const known = {"files", "--root", "--cxx",    "--cc",       "--numeric",
                                              "-p",    "-j",     "--config", "--type-name"};
  for (CLI::Option const *one : command.get_options())
    if (one->count() != 0 && known.count(one->get_name()) == 0 && session.configured.count(one->get_name()) == 0)
      fail(DiagnosticId::option_without_effect, {}, one->get_name() + " is not for --numeric");
  rewrite::Request const request = only_rewritten(project.complete(session.flags));
  std::vector<rewrite::Compilation> const sources = rewrite::compilations_of(request);
  rewrite::Result const rewritten = rewrite::run(request);
  // What stands in the way of the symbolic program, such as a function that is defined elsewhere, does not concern the
  // numeric one.
  bool const is_broken = rewritten.files.empty();
  std::size_t obstacles = 0;
  for (Diagnostic const &diagnostic : rewritten.diagnostics) {
    bool const is_error = diagnostic.severity == Severity::error;
    obstacles += is_error ? 1 : 0;
    if (is_broken || !is_error) print(std::cerr, diagnostic);
  }
  if (is_broken && obstacles != 0) return error;
  if (obstacles != 0)
    std::cerr << "note: " << obstacles << " obstacles to the symbolic program do not count here; `symreal scan` lists "
              << "them\n";
  program::Workspace const workspace(/*keep=*/false);
  program::ObjectComparison const result =
      program::compare_object_code(sources, rewritten, {options.c_compiler, cxx_compiler}, request.jobs, workspace);
  for (Diagnostic const &diagnostic : result.diagnostics) print(std::cerr, diagnostic);
  std::cout << result.identical << " of " << sources.size() << " translation units have identical object code\n";
  if (result.identical != result.compared) return verification_failed;
  return result.compared == sources.size() ? clean : error;
}

} // namespace symreal::tool
