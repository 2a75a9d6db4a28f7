#include "tool/report/console.h"

#include <iostream>
#include <unistd.h>

namespace symreal::tool {

Console::Console() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

program::Talk Console::talk() {
  return {[this](std::string_view name) { stage(name); }, [this](Diagnostic const &diagnostic) { report(diagnostic); },
          [this](std::string_view line) {
            clear();
            std::cerr << "program| " << line << "\n";
          },
          [this](std::string const &text) { note(text); }};
}

void Console::stage(std::string_view name) {
  if (!is_terminal_) return;
  clear();
  std::cerr << "symreal: " << name << " ..." << std::flush;
  line_shown_ = true;
}

void Console::report(Diagnostic const &diagnostic) {
  clear();
  print(std::cerr, diagnostic);
}

void Console::note(std::string const &text) {
  clear();
  std::cerr << "symreal: " << text << "\n";
}

void Console::clear() {
  if (line_shown_) std::cerr << "\r\033[K" << std::flush;
  line_shown_ = false;
}

} // namespace symreal::tool
