// What a user asks to be differentiated: "jacobian(tau, [q, qd])", "hessian(cost, q, sparse)".
#pragma once

#include "engine/graph/graph.h"

#include <string>
#include <vector>

namespace symreal {

enum class DerivativeKind : std::uint8_t { jacobian, gradient, hessian, jvp, vjp };

// Names that are found in a graph: the numbers of the objects, and the slots of their elements in that order.
struct DerivativeRequest {
  DerivativeKind kind = DerivativeKind::jacobian;
  std::vector<std::string> outputs, inputs; // identifiers
  std::vector<std::uint32_t> output_slots, input_slots;
  Place place = {};                                                  // of the first output
  std::string name;                                                  // of the object that is added: jacobian_tau_q_qd
  bool is_sparse = false, is_symmetric = false, is_weighted = false; // the words behind the inputs

  bool is_matrix() const { return kind == DerivativeKind::jacobian || kind == DerivativeKind::hessian; }
  bool is_packed() const { return is_sparse || is_symmetric; }
  // Of the whole, also where it is packed.
  std::vector<std::size_t> extents() const;
  // How many inputs it needs besides, a direction or weights, and what these are called. Requests that call them the
  // same have them in common.
  std::size_t seed_count() const;
  std::string seed_label() const;
};

// Throws, at the place of the wish, bad_derivative for another form and for names that the graph does not have,
// not_a_scalar (of an option at the place of the output). An object is named by its label, with sections or without, or
// as the header spells it. Without inputs: all of them.
DerivativeRequest read_request(DerivativeWish const &wish, Graph const &graph);

} // namespace symreal
