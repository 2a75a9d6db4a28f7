#include "tool/options/recovery.h"

#include "engine/diagnostics/diagnostic.h"

#include <iostream>

namespace symreal::tool {

program::Recovery recover(std::string const &directory) {
  program::Recovery const recovery = program::recover_tree(directory);
  auto const say = [&](char const *message) {
    print(std::cerr, {DiagnosticId::interrupted_edit, {directory}, message});
  };
  switch (recovery) {
  case program::Recovery::nothing: break;
  case program::Recovery::completed: say("a rewrite that was interrupted was completed"); break;
  case program::Recovery::taken_back: say("a rewrite that was interrupted was taken back"); break;
  case program::Recovery::undone: say("an undo that was interrupted was completed"); break;
  case program::Recovery::not_undone: say("an undo that was interrupted was taken back"); break;
  }
  return recovery;
}

} // namespace symreal::tool
