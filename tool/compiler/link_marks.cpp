#include "tool/compiler/link_marks.h"

#include "rewrite/text/pragma_text.h"

#include <cctype>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>

namespace symreal::compiler {
namespace {

constexpr std::string_view prefix = "symreal_mode_";

std::string mark(std::string const &mangled) {
  std::string name(prefix);
  for (char c : mangled)
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '_'
                ? std::string(1, c)
                : "_x" + std::to_string(static_cast<unsigned char>(c)) + "_";
  return name;
}

std::string demangled(std::string const &name) {
  int status = 0;
  std::unique_ptr<char, void (*)(void *)> const text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                     std::free);
  return status == 0 && text ? text.get() : name;
}

} // namespace

std::string link_marks(rewrite::Result const &rewritten) {
  std::string text = "\n";
  for (std::string const &mangled : rewritten.definitions)
    text += "extern \"C\" __attribute__((weak, visibility(\"default\"))) char const " + mark(mangled) + " = 0;\n";
  for (rewrite::Boundary const &boundary : rewritten.boundaries) {
    std::string const name = mark(boundary.mangled);
    // The #line directive makes the linker name the place of the use.
    text += "extern \"C\" char const " + name + ";\n#line " + std::to_string(boundary.use.line) + " " +
            in_quotes(boundary.use.file) + "\n__attribute__((used)) static char const *const symreal_needs_" + name +
            " = &" + name + ";\n";
  }
  return text;
}

std::set<std::string> missing_marks(std::string const &linker_output) {
  std::set<std::string> functions;
  for (std::size_t at = 0; (at = linker_output.find(prefix, at)) != linker_output.npos;) {
    at += prefix.size();
    std::size_t end = at;
    while (end < linker_output.size() &&
           (std::isalnum(static_cast<unsigned char>(linker_output[end])) || linker_output[end] == '_'))
      ++end;
    functions.insert(demangled(linker_output.substr(at, end - at)));
  }
  return functions;
}

} // namespace symreal::compiler
