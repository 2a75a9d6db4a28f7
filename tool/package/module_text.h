// Python sources of a package.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>

namespace symreal::tool {

// Python without a prefix before names, since the module separates them.
Language package_language();

// Text of __init__.py, with the names of the plain module (emit/languages/python.cpp).
std::string module_text(Schedule const &plan, EmitOptions const &options);
// Text of __init__.pyi: its types.
std::string stub_text(Schedule const &plan, EmitOptions const &options);
// Text of the test in the package.
std::string test_text(Schedule const &plan, EmitOptions const &options);

} // namespace symreal::tool
