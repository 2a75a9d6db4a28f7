#include "support/installation.h"

namespace symreal {

std::string const &runtime_include() {
  static std::string const path = SYMREAL_RUNTIME_INCLUDE;
  return path;
}

std::string const &runtime_library() {
  static std::string const path = SYMREAL_RUNTIME_LIBRARY;
  return path;
}

} // namespace symreal
