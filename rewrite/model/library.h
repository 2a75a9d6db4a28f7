// Traits of library functions and classes: the table in library.def. Names are without scopes; the caller checks the
// scope.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite::library {

enum Function : unsigned {
  ALLOCATES = 1 << 0,
  MOVES_BYTES = 1 << 1,
  SEARCHES = 1 << 2,
  TEXT_TO_MEMORY = 1 << 3,
  TEXT_TO_FILE = 1 << 4,
  READS_TEXT = 1 << 5,
  GIVES_ARGUMENT = 1 << 6,
  ONLY_WRITES = 1 << 7,
  MATH = 1 << 8,
  COMPARES = 1 << 9,
  ERROR_NUMBER = 1 << 10,
  ENVIRONMENT = 1 << 11,
  ONLY_READS = 1 << 12,
};
enum Method : unsigned { READS_ITS_TEXT = 1, COMPARES_KEYS = 2, VIEWS = 4 };
enum Class : unsigned { OWNS_ELEMENTS = 1, OWNS_SCALARS = 2, VIEW = 4, VALUE = 8, POINTER = 16, LENDS = 32, ANY = 63 };

// Whether the row of this name, if any, has the trait.
bool has(llvm::StringRef function, Function trait);
bool has(llvm::StringRef method, Method trait);
bool has(llvm::StringRef scope, llvm::StringRef class_name, Class trait);

// Effect of a function on the floating-point environment; empty for any other function.
llvm::StringRef environment_effect(llvm::StringRef function);

} // namespace symreal::rewrite::library
