#include "diagnostics/diagnostic.h"
#include "tool/subcommands.h"

#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

// Prose to lines of at most 80 columns.
std::string wrapped(std::string_view text) {
  constexpr std::size_t width = 80;
  std::string result;
  while (text.size() > width) {
    std::size_t cut = text.rfind(' ', width);
    if (cut == text.npos) break;
    result.append(text.substr(0, cut)) += '\n';
    text.remove_prefix(cut + 1);
  }
  return result.append(text) + "\n";
}

void explain(DiagnosticInfo const &row) {
  std::cout << code(row.id) << ": " << row.summary << "\n\n"
            << wrapped(row.explanation) << "\n"
            << wrapped("Way out: " + std::string(row.way_out) + ".");
}

void list() {
  for (DiagnosticInfo const &row : diagnostic_table()) std::cout << code(row.id) << "  " << row.summary << "\n";
}

} // namespace

void add_explain(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("explain", "Say what a diagnostic means and what to do; without id, list all");
  auto wanted = std::make_shared<std::string>();
  command->add_option("id", *wanted, "As in SYM012");
  command->callback([wanted, &session] {
    refuse_flags(session);
    if (wanted->empty()) return list();
    DiagnosticInfo const *row = find_diagnostic(*wanted);
    if (!row) fail(DiagnosticId::bad_option, {}, "no diagnostic has the id '" + *wanted + "'");
    explain(*row);
  });
}

} // namespace symreal::tool
