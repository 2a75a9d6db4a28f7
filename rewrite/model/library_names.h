// Names of the C library at file scope.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

bool is_library_name(llvm::StringRef name);

} // namespace symreal::rewrite
