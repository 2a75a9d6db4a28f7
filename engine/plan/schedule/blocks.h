// The statements of one chunk with the blocks of their regions around them.
//
// Neighbours of one region share a block. A variable that is read outside of its block is declared before the outermost
// one, with the value 0 that it keeps where the block is not entered; nobody uses it then. Blocks end with the chunk.
#pragma once

#include "engine/plan/schedule/chunks.h"

namespace symreal {

struct Step {
  enum class Kind {
    declare,   // variable `index`, which is set in a block and read outside
    open,      // a block: if (literal)
    otherwise, // ends a block and begins its else
    close,     // the innermost block
    set,       // variable `index`
    set_const, // the same, declared here
    keep,      // stores variable `index` in its spill slot
    check,     // guard `index`
    copy,      // stores number `index` of what is copied from the input
    store,     // stores result `index`
  } kind;
  std::size_t index = 0; // of a statement of the body; of a check
  Literal literal = {};
};

std::vector<Step> blocks(Schedule const &plan, FunctionBody const &body, bool in_compute, Chunks const &chunks,
                         std::size_t chunk);

} // namespace symreal
