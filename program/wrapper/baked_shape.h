// Shape of a baked-in value: the extents and members of an object of C or C++, down to what can be compared.
#pragma once

#include "rewrite/facts/result.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal::program {

// A parsed shape of rewrite/model/signature.h.
struct BakedShape {
  std::vector<std::size_t> extents;
  char kind = 0;    // '{' if it has members
  std::string name; // member name
  std::vector<BakedShape> members;
};

BakedShape shape_of(rewrite::Baked const &baked);

// The inverse of shape_of.
std::string written(BakedShape const &shape);

// Calls `visit` with each leaf member; removes members for which it returns false.
bool keep_members(BakedShape &shape, std::string const &name,
                  std::function<bool(std::string const &name, char kind)> const &visit);

// Loops over an object's values; `leaf` gives the statement on each, by its kind (rewrite/model/signature.h).
using BakedLeaf = std::function<std::string(std::string const &element, char kind)>;
std::string baked_statements(rewrite::Baked const &baked, std::vector<std::string> const &lengths,
                             BakedLeaf const &leaf);

} // namespace symreal::program
