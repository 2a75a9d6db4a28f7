// Derivative requests of the user: "jacobian(tau, [q, qd])", "hessian(cost, q, sparse)".
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal {

enum class DerivativeKind : std::uint8_t { jacobian, gradient, hessian, jvp, vjp };

// A request resolved in a graph: the identifiers of the objects, and the slots of their elements in that order.
struct DerivativeRequest {
  DerivativeKind kind = DerivativeKind::jacobian;
  std::vector<std::string> outputs, inputs; // identifiers
  std::vector<std::uint32_t> output_slots, input_slots;
  Place place = {};                                                  // of the first output
  std::string name;                                                  // of the added object: jacobian_tau_q_qd
  bool is_sparse = false, is_symmetric = false, is_weighted = false; // the flags after the inputs

  bool is_matrix() const { return kind == DerivativeKind::jacobian || kind == DerivativeKind::hessian; }
  bool is_packed() const { return is_sparse || is_symmetric; }
  // Extents of the unpacked result.
  std::vector<std::size_t> extents() const;
  // Number of added inputs, a direction or weights, and their label. Requests with the same label share them.
  std::size_t seed_count() const;
  std::string seed_label() const;
};

// Parses a request. An object is named by its label, with or without sections, or by its identifier in the header.
// Without inputs, it takes all. Throws, at the location of the wish, bad_derivative for malformed text and unknown
// names, not_a_scalar (of an option, at the location of the output).
DerivativeRequest read_request(DerivativeWish const &wish, Graph const &graph);

} // namespace symreal
