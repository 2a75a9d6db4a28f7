#include "tool/fmu/unit_library.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/process.h"
#include "program/build/workspace.h"

#include <sys/utsname.h>

namespace symreal::tool {

std::string unit_platform() {
  utsname machine{};
  internal_check(uname(&machine) == 0);
  return std::string(machine.machine) + "-linux";
}

std::string unit_library(std::vector<std::pair<std::string, std::string>> const &files) {
  program::Workspace const workspace(false);
  std::vector<std::string> command = {"cc", "-shared"};
  for (std::string &option : program::split_words(unit_compiler_options)) command.push_back(std::move(option));
  for (auto const &[name, text] : files) {
    write_if_changed(workspace.file(name), text);
    if (name.ends_with(".c")) command.push_back(name);
  }
  command.insert(command.end(), {"-lm", "-o", "unit.so"});
  program::Captured const compiled =
      program::capture({.arguments = command, .directory = workspace.path(), .environment = {"LC_ALL=C"}});
  if (compiled.outcome.ending == program::Ending::not_started)
    fail(DiagnosticId::compiler_missing, {}, "'cc' compiles the unit for this machine, and cannot be run");
  if (!compiled.outcome.success())
    fail(DiagnosticId::bad_option, {}, "'cc' cannot compile the unit for this machine:\n" + compiled.output);
  return read_file(workspace.file("unit.so"));
}

} // namespace symreal::tool
