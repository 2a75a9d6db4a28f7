// Locals of a function around a block kernel. They outlive the kernel, and the values that it reads are baked in;
// unlike other state they may be changed, since no other function knows them.
#pragma once

#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

class Surroundings {
public:
  // Finds the blocks, and adds the locals around each to the pragma that begins it.
  Surroundings(clang::ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
               Facts &facts);

  // Whether the variable is a number, or an object of numbers, from outside of a block that mentions it here.
  bool contain(clang::VarDecl const *variable, clang::SourceLocation mention) const;

private:
  friend class BlockFunctions;

  SourceMap const &map_;
  // Begin and end of the blocks that may use the variable, in its file.
  std::map<clang::VarDecl const *, std::vector<std::pair<std::size_t, std::size_t>>> blocks_;
};

} // namespace symreal::rewrite
