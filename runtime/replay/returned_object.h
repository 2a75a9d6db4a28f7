// The members of a returned object that are not numbers: generated code has the numbers alone.
#pragma once

#include <cstdint>
#include <string_view>

namespace symreal::replay {

// A hash of it. `others` says where it lies (rewrite/facts/signature.h).
std::uint64_t hash_of_others(char const *object, std::string_view others);

} // namespace symreal::replay
