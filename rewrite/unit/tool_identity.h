// Identity of this tool, down to the bytes of its code.
#pragma once

#include <string>

namespace symreal::rewrite {

// Another text for another build of this program or of a library that it is loaded with, Clang's among them: the
// linker gives each an identity that follows from its contents.
std::string const &tool_identity();

} // namespace symreal::rewrite
