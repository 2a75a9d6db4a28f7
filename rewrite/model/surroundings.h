// The locals of a function around a block kernel. They live longer than the kernel, and what it reads of them is baked
// in; unlike other state they may be changed, since nobody else knows them.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

class Surroundings {
public:
  // Looks for the blocks, and tells the pragma that begins each which locals there are.
  Surroundings(clang::ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
               Facts &facts);

  // Is it a number, or an object of numbers, that a block finds there, mentioned within the block?
  bool contain(clang::VarDecl const *variable, clang::SourceLocation mention) const;

private:
  friend class BlockFunctions;

  SourceMap const &map_;
  // Where the blocks that may use it begin and end, in its file.
  std::map<clang::VarDecl const *, std::vector<std::pair<std::size_t, std::size_t>>> blocks_;
};

} // namespace symreal::rewrite
