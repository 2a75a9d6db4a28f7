// The payload of a node (symreal/real_number.h): its id, and 18 check bits above it. The id has some bits inverted, so
// that zeros stored into a small id change it.
//
// The check bits are a hash of the id plus a multiple of the recording's generation. For one id, those of two
// generations differ: a node of another recording is detected for certain. A number of which some bytes were
// overwritten, with zeros, with those of another node or with anything else, has the check bits of its id with a chance
// of 2^-18. Hence the hash is one that scatters: with a linear one the differences between ids would decide, and ids
// that differ in one byte would all have the same check bits, or none.
#pragma once

#include "engine/graph/node.h"

#include <symreal/real_number.h>

#include <cstdint>

namespace symreal::trace::payload {

inline constexpr std::uint32_t check_mask = (1u << (detail::node_shape_at - 32)) - 1;
// Bits in the shape of a node, with zero check bits.
inline constexpr std::uint64_t signaling = detail::node_shape << detail::node_shape_at;
// Step of the check bits from one generation to the next. Check bits 0 become 1, and no two generations are that close.
inline constexpr std::uint32_t generation_step = 0x1'9E37u;

constexpr std::uint32_t hash(NodeId id) {
  id = (id ^ id >> 16) * 0x7FEB'352Du;
  id = (id ^ id >> 15) * 0x846C'A68Bu;
  return id >> 14;
}

inline constexpr std::uint32_t inverted = 0xA96C'3F5Bu;
constexpr NodeId id_of(std::uint64_t bits) { return static_cast<NodeId>(bits) ^ inverted; }

// Bits 63..32 of a node. `offset`: of its generation.
constexpr std::uint32_t offset_of(std::uint32_t generation) { return generation * generation_step; }
constexpr std::uint32_t upper_half(NodeId id, std::uint32_t offset) {
  std::uint32_t const check = (hash(id) + offset) & check_mask;
  return static_cast<std::uint32_t>(signaling >> 32) + check + (check == 0 ? 1 : 0);
}

constexpr std::uint64_t bits_of(NodeId id, std::uint32_t offset) {
  return std::uint64_t{upper_half(id, offset)} << 32 | (id ^ inverted);
}

// Inverse of the step modulo a power of two; each Newton step doubles the correct bits.
inline constexpr std::uint32_t inverse_step = [] {
  std::uint32_t inverse = generation_step;
  for (int k = 0; k < 4; ++k) inverse *= 2 - generation_step * inverse;
  return inverse;
}();

// The generation that the check bits belong to; for a torn number any of 2^18.
constexpr std::uint32_t generation_of(std::uint64_t bits) {
  NodeId const id = id_of(bits);
  auto const check = static_cast<std::uint32_t>(bits >> 32) & check_mask;
  std::uint32_t const known = ((check - hash(id)) * inverse_step) & check_mask;
  if (check != 1) return known;
  std::uint32_t const of_zero = ((0 - hash(id)) * inverse_step) & check_mask;
  return of_zero < known ? of_zero : known;
}

} // namespace symreal::trace::payload
