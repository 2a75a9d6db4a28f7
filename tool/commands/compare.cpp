#include "graph/graph_text.h"
#include "graph/statistics.h"
#include "support/files.h"
#include "tool/commands/subcommands.h"

#include <fmt/ostream.h>
#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

OperationCounts operations_of(std::string const &file) {
  return statistics(read_graph(read_file(file), file)).recorded;
}

void print_row(std::string_view name, std::size_t first, std::size_t second) {
  fmt::print(std::cout, "{:<16}{:>12}{:>12}\n", name, first, second);
}

void compare(std::string const &first_file, std::string const &second_file) {
  OperationCounts const first = operations_of(first_file), second = operations_of(second_file);
  fmt::print(std::cout, "{:<16}{:>12}{:>12}\n", "operations", "first", "second");
  for (OperationInfo const &operation : operations())
    if (first[operation.op] != 0 || second[operation.op] != 0)
      print_row(operation.name, first[operation.op], second[operation.op]);
  print_row("+ - * / together", first.arithmetic(), second.arithmetic());
}

} // namespace

void add_compare(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("compare", "Print which operations two graphs have, side by side");
  auto files = std::make_shared<std::pair<std::string, std::string>>();
  command->add_option("first", files->first, "Graph text, as written by generate --graph or opt")->required();
  command->add_option("second", files->second, "The graph to compare it with")->required();
  command->callback([files, &session] {
    refuse_flags(session);
    compare(files->first, files->second);
  });
}

} // namespace symreal::tool
