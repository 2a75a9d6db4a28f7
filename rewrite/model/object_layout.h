// The places of the numbers and scalars of a structure, written down for the runtime.
//
// A program in C, private members and packed ones can be reached by their offsets alone, so this is the one way into
// structures for all programs that a kernel is built as: symbolic, replay and original lay them out alike (layouts.h).
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct DescribedObject {
  ObjectLayout layout;               // no text where the type itself tells how to get to the numbers, or has none
  std::string refusal;               // why it cannot be annotated
  std::vector<std::string> pointers; // members that point to numbers, which are no part of the object
  std::vector<std::string> others;   // members with numbers that stay as they are
};

// `is_packed`: the object may lie anywhere, so that no reference can be bound to it.
DescribedObject describe_object(clang::QualType type, bool is_packed, clang::ASTContext const &context,
                                Reals const &reals);

// Of a class that the runtime takes for a sequence or a matrix (<symreal/numbers.h>): what its elements are; else null.
clang::QualType element_of(clang::CXXRecordDecl const *record);

} // namespace symreal::rewrite
