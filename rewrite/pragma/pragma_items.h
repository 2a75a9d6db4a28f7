// Resolution of pragma items: their types, the numbers in them, the elements that they name. Region items are resolved
// by the statements that the pragma handler put into the token stream, those of function pragmas in function_pragmas.h.
#pragma once

#include "rewrite/model/item_type.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/pragma/pragma_handler.h"

#include <vector>

namespace symreal::rewrite {

// Notes for a statement inserted for a pragma's item that the item was seen there, and its type.
void note_item(clang::Stmt const *statement, clang::ASTContext const &context, Reals const &reals,
               ScalarState const &scalars, PragmaIndex const &index, Facts &facts);

// Notes the variables of static storage duration that a file defines, as the linker knows them, in the items of this
// source's pragmas that mean it, `scratch(file)`, and those that the program may change in the facts.
void note_statics(clang::ASTContext &context, SourceMap const &map, ScalarState const &scalars, Facts &facts);

// Whether the clause annotates its items as a whole: their numbers are inputs, parameters or outputs.
bool takes_numbers(ClauseFact const &clause);

Base kind_of(clang::ValueDecl const *declaration, clang::ASTContext const &context);

// Notes the declaration of an item that is a plain name, or a section of one.
void note_declaration(ItemFact &item, clang::ValueDecl const *declaration);

void note_layout(ClauseFact const &clause, ItemFact &item, ItemType const &type, clang::ASTContext const &context,
                 Reals const &reals, Facts &facts);

// An element beyond an object whose size is known from declarations is an error; where only the run knows the size, or
// the element, the annotation tests it (ItemFact::tested). `indices`: the brackets of the item's expression.
void note_bounds(ClauseFact const &clause, ItemFact &item, std::vector<ItemIndex> const &indices, LookUp look_up,
                 Facts &facts);

} // namespace symreal::rewrite
