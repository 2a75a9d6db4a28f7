// Functions and classes of libraries: their traits are the rows of library.def, and the names of the C library those of
// library_names.def.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// Names in the table are without scopes; the caller checks the scope.
namespace library {

enum Function : unsigned {
  ALLOCATES = 1 << 0,
  MOVES_BYTES = 1 << 1,
  SEARCHES = 1 << 2,
  TEXT_TO_MEMORY = 1 << 3,
  TEXT_TO_FILE = 1 << 4,
  READS_TEXT = 1 << 5,
  GIVES_ARGUMENT = 1 << 6,
  ONLY_WRITES = 1 << 7,
  COMPARES = 1 << 8,
  ERROR_NUMBER = 1 << 9,
  ENVIRONMENT = 1 << 10,
  ONLY_READS = 1 << 11,
};
enum Method : unsigned { READS_ITS_TEXT = 1, COMPARES_KEYS = 2, VIEWS = 4 };
enum Class : unsigned { OWNS_ELEMENTS = 1, OWNS_SCALARS = 2, VIEW = 4, VALUE = 8, POINTER = 16, LENDS = 32, ANY = 63 };

// Whether the row of this name, if any, has the trait.
bool has(llvm::StringRef function, Function trait);
bool has(llvm::StringRef method, Method trait);
bool has(llvm::StringRef scope, llvm::StringRef class_name, Class trait);

// Effect of a function on the floating-point environment; empty for any other function.
llvm::StringRef environment_effect(llvm::StringRef function);

} // namespace library

// Whether the C library has the name at file scope.
bool is_library_name(llvm::StringRef name);

// Whether the function is one of these of namespace std.
bool is_std_function(clang::FunctionDecl const *function, std::initializer_list<llvm::StringRef> names);
// Whether the record is this class of namespace std; null is not.
bool is_std_class(clang::CXXRecordDecl const *record, llvm::StringRef name);

// Whether the address of REAL objects may go to this function of the C library that takes memory of any type: it moves
// bytes, which carry nodes as well as numbers, or it is watched (collect/bits.cpp).
bool moves_bytes(clang::FunctionDecl const *function);

enum class TextUse { none, memory, outside, reader };

TextUse text_use(clang::FunctionDecl const *function);

// Whether a member of a string or stream has a result that depends on the text held.
bool reads_its_text(clang::CXXMethodDecl const *method);
// Whether a member of a container compares its argument with its keys.
bool compares_keys(clang::CXXMethodDecl const *method);

// Whether the type is characters in memory, a string, a file or a stream.
bool is_text(clang::QualType type);
bool is_string(clang::QualType type);
// Whether the type is a file or a stream: the argument beside it receives the text.
bool is_source(clang::QualType type);
// Whether the type is a single byte that may be a character.
bool is_character(clang::QualType type);
// Whether the type is a character that is not a small integer, as signed char is.
bool is_text_character(clang::QualType type);
// Whether text written to an object of the type can be read from it.
bool keeps_text(clang::QualType type);

} // namespace symreal::rewrite
