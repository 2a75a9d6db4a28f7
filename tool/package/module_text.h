// The Python sources of a package.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>

namespace symreal::tool {

// Python for a module of its own: no prefix stands before names.
Language package_language();

// __init__.py, with the names that the plain module has (emit/languages/python.cpp).
std::string module_text(Schedule const &plan, EmitOptions const &options);
// __init__.pyi: its types.
std::string stub_text(Schedule const &plan, EmitOptions const &options);
// The test that the package brings along.
std::string test_text(Schedule const &plan, EmitOptions const &options);

} // namespace symreal::tool
