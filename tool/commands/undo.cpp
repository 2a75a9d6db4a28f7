#include "program/build/tree_edit.h"
#include "tool/commands/subcommands.h"
#include "tool/options/source_options.h"

#include <iostream>
#include <memory>

namespace symreal::tool {

void add_undo(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("undo", "Take back the last rewrite --in-place");
  auto directory = std::make_shared<std::string>(".");
  command->add_option("directory", *directory, "Directory of the files, or one below (default: .)");
  command->callback([directory, &session] {
    refuse_flags(session);
    program::Recovery const recovery = recover(*directory);
    // Recovery alone has already restored the tree.
    if (recovery == program::Recovery::taken_back || recovery == program::Recovery::undone) return;
    for (std::string const &file : program::undo_tree(*directory)) std::cout << file << "\n";
  });
}

} // namespace symreal::tool
