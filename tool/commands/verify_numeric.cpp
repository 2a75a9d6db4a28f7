#include "tool/commands/verify_numeric.h"

#include "engine/diagnostics/diagnostic.h"
#include "verify/numeric_identity.h"

#include <algorithm>
#include <iostream>
#include <set>

namespace symreal::tool {

void NumericOptions::add_to(CLI::App &app) {
  app.add_flag("--numeric", enabled,
               "Compare only the object code of all sources before and after rewriting, without the switch");
  app.add_option("--cc", c_compiler,
                 "Compiler of sources that end in .c; by default cc, with --numeric that of their build");
}

int verify_numeric(CLI::App const &command, NumericOptions const &options, ProjectOptions const &project,
                   std::string const &cxx_compiler, bool keep, Session const &session) {
  static std::set<std::string> const known = {"files", "--root", "--cxx",    "--cc",        "--numeric",
                                              "-p",    "-j",     "--config", "--type-name", "--keep"};
  for (CLI::Option const *one : command.get_options())
    if (one->count() != 0 && known.count(one->get_name()) == 0 && session.configured.count(one->get_name()) == 0)
      fail(DiagnosticId::option_without_effect, {}, one->get_name() + " has no effect with --numeric");
  rewrite::Request request = only_rewritten(project.complete(session.flags));
  request.leave_out_broken = true;
  std::vector<rewrite::Compilation> sources = rewrite::compilations_of(request);
  std::size_t const asked = sources.size();
  rewrite::Result const rewritten = rewrite::run(request);
  // Obstacles to the symbolic program, such as functions defined elsewhere, do not affect the numeric one.
  std::size_t obstacles = 0;
  for (Diagnostic const &diagnostic : rewritten.diagnostics) {
    bool const is_obstacle = diagnostic.severity == Severity::error && diagnostic.id != DiagnosticId::source_error;
    obstacles += is_obstacle ? 1 : 0;
    if (!is_obstacle) print(std::cerr, diagnostic);
  }
  if (obstacles != 0)
    std::cerr << "note: " << obstacles << " obstacles to the symbolic program do not count here; `symreal scan` lists "
              << "them\n";
  for (std::string const &source : rewritten.left_out) std::cerr << "left out, does not compile: " << source << "\n";
  std::erase_if(sources, [&](rewrite::Compilation const &one) {
    return std::find(rewritten.left_out.begin(), rewritten.left_out.end(), one.source) != rewritten.left_out.end();
  });
  program::Workspace const workspace(keep);
  if (keep) std::cerr << "the objects and the rewritten sources are in " << workspace.path() << "\n";
  program::ObjectComparison const result =
      program::compare_object_code(sources, rewritten, {options.c_compiler, cxx_compiler}, request.jobs, workspace);
  for (Diagnostic const &diagnostic : result.diagnostics) print(std::cerr, diagnostic);
  std::cout << result.identical << " of " << asked << " translation units have identical object code\n";
  if (result.identical != result.compared) return verification_failed;
  return result.compared == asked ? clean : error;
}

} // namespace symreal::tool
