// What functions of the library do with text (library.def).
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

enum class TextUse { none, memory, outside, reader };

TextUse text_use(clang::FunctionDecl const *function);

// A member of a string or stream whose result depends on what that holds.
bool reads_its_text(clang::CXXMethodDecl const *method);
// A member of a container that compares its argument with its keys.
bool compares_keys(clang::CXXMethodDecl const *method);

// Characters in memory, a string, a file or a stream.
bool is_text(clang::QualType type);
bool is_string(clang::QualType type);
// A file or a stream: what is given beside it is where the text goes.
bool is_source(clang::QualType type);
// One byte that may be a character.
bool is_character(clang::QualType type);
// An object that text is written to and that it can be read from.
bool keeps_text(clang::QualType type);

} // namespace symreal::rewrite
