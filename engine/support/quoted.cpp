#include "engine/support/quoted.h"

namespace symreal {

std::string escaped(std::string const &text) {
  std::string result;
  for (char const c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string in_quotes(std::string const &text) { return '"' + escaped(text) + '"'; }

} // namespace symreal
