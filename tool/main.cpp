// Command line of the tool: symreal SUBCOMMAND [options] files [-- compiler flags].
#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "engine/support/installation.h"
#include "program/build/read_files.h"
#include "tool/commands/subcommands.h"
#include "tool/configuration/unknown_words.h"
#include "tool/options/option_table.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

namespace symreal::tool {

void refuse_flags(Session const &session) {
  if (!session.flags.empty())
    fail(DiagnosticId::option_without_effect, {},
         "this subcommand compiles nothing, so '" + session.flags.front() + "' after -- has no effect");
}

static int run(int argc, char **argv) {
  Session session;
  char **separator = std::find_if(argv, argv + argc, [](char const *word) { return std::string_view(word) == "--"; });
  if (separator != argv + argc) session.flags.assign(separator + 1, argv + argc);

  CLI::App app("Turns numeric C and C++ into optimised straight-line C and proves that it is the same.", "symreal");
  app.set_version_flag("--version", "symreal " + std::string(version));
  app.require_subcommand(1);
  app.footer("After -- stand the compiler flags of the sources, or the program of record.\n"
             "Exit status: 0 clean, 1 error, 2 partly skipped, 3 verification failed, 4 output out of date.");
#define SUBCOMMAND(name) add_##name(app, session);
#include "tool/commands/subcommands.def"
#undef SUBCOMMAND
  arrange_help(app);
  std::vector<std::string> words(argv + 1, separator);
  if (words.empty()) {
    std::cout << app.help();
    return error;
  }
  if (words.front() == "help") { // help SUBCOMMAND means SUBCOMMAND --help
    words.erase(words.begin());
    auto const is_named = [&](CLI::App const *one) { return one->get_name() == words.front(); };
    if (words.empty() || !app.get_subcommands(is_named).empty()) words.emplace_back("--help");
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend())); // CLI11 expects the words in reverse
    return session.status;
  } catch (CLI::ParseError const &problem) {
    if (problem.get_exit_code() == 0) return app.exit(problem);
    std::string const explained = explain_unknown(app, words);
    print(std::cerr, {DiagnosticId::bad_option, {}, explained.empty() ? problem.what() : explained});
  } catch (DiagnosticError const &problem) {
    print(std::cerr, located(problem.diagnostic(), session.configured));
  } catch (std::bad_alloc const &) {
    print(std::cerr, {DiagnosticId::out_of_memory, {}, "the system gives no more memory to work on the graph"});
  }
  return error;
}

} // namespace symreal::tool

int main(int argc, char **argv) {
  symreal::watch_reads(symreal::program::note_read);
  try {
    return symreal::tool::run(argc, argv);
  } catch (std::exception const &problem) {
    std::fprintf(stderr, "symreal: internal error: %s\n", problem.what());
    return symreal::tool::error;
  }
}
