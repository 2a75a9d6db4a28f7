// Statements of one chunk, enclosed in the blocks of their regions.
//
// Neighbours of one region share a block. A variable read outside its block is declared before the outermost block,
// with the value 0, which it keeps, unread, if the block is not entered. Blocks end with the chunk.
#pragma once

#include "engine/plan/schedule/chunks.h"

namespace symreal {

struct BlockStep {
  enum class Kind {
    declare,   // variable `index`, set in a block and read outside
    open,      // a block: if (literal)
    otherwise, // ends a block and begins its else
    close,     // the innermost block
    set,       // variable `index`
    set_const, // variable `index`, declared here
    keep,      // stores variable `index` in its spill slot
    check,     // guard `index`
    copy,      // stores copy `index` of an array element
    store,     // stores result `index`
  } kind;
  std::size_t index = 0; // index of a statement, variable, or guard
  Literal literal = {};
};

std::vector<BlockStep> blocks(Plan const &plan, PlanFunction const &body, Chunks const &chunks, std::size_t chunk);

} // namespace symreal
