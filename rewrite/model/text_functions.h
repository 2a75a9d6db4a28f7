// Classification of library functions and types that handle text (library.def).
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

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
// Whether text written to an object of the type can be read from it.
bool keeps_text(clang::QualType type);

} // namespace symreal::rewrite
