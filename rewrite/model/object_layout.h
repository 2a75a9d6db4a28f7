// Layout texts: the places of the numbers and scalars of a structure, written down for the runtime, and objects that a
// wrapper returns.
//
// Programs in C, private members and packed ones allow access by offset only, so this is the one way into structures
// for all programs that a kernel is built as: symbolic, replay and original lay them out alike (layouts.h).
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct DescribedObject {
  ObjectLayout layout;               // empty text if the type itself leads to the numbers, or has no numbers
  std::string refusal;               // why it cannot be annotated
  std::vector<std::string> pointers; // members that point to numbers, which the object does not include
  std::vector<std::string> others;   // members with numbers that are not converted
};

// `is_packed`: the object may be misaligned, so that a reference cannot be bound to it.
DescribedObject describe_object(clang::QualType type, bool is_packed, clang::ASTContext const &context,
                                Reals const &reals);

// Element type of a class that the runtime takes for a sequence or a matrix (<symreal/numbers.h>); else null.
clang::QualType element_of(clang::CXXRecordDecl const *record);

// Whether the type is a pointer to constant characters.
bool is_constant_text(clang::QualType type);

ReturnedObject returned_object(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
