#include "engine/diagnostics/diagnostic.h"
#include "tool/commands/subcommands.h"
#include "tool/options/option_table.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

// Wraps prose at 80 columns.
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
            << wrapped("Help: " + std::string(row.help) + ".");
}

void list_json() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (DiagnosticInfo const &row : diagnostic_table())
    rows.push_back(
        {{"id", code(row.id)}, {"summary", row.summary}, {"explanation", row.explanation}, {"help", row.help}});
  std::cout << rows.dump(1) << "\n";
}

void list() {
  for (DiagnosticInfo const &row : diagnostic_table()) std::cout << code(row.id) << "  " << row.summary << "\n";
}

} // namespace

void add_explain(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("explain", "Explain a diagnostic; without an id, list all");
  auto wanted = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command->add_option("id", *wanted, "As in SYM012");
  command->add_flag("--json", *json, "List all as JSON");
  command->callback([wanted, json, command, &session] {
    refuse_flags(session);
    require_compatible(*command);
    if (wanted->empty()) return *json ? list_json() : list();
    DiagnosticInfo const *row = find_diagnostic(*wanted);
    if (!row) fail(DiagnosticId::bad_option, {}, "no diagnostic has the id '" + *wanted + "'");
    explain(*row);
  });
}

} // namespace symreal::tool
