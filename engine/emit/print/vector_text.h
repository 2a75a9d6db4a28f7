// Printing of vectors: nested like scalar expressions, with variables for multiple uses.
#pragma once

#include "engine/emit/print/emission.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal {

class VectorText {
public:
  VectorText(Emission const &emission, lanes::LaneFunction const &function);

  // Whether the vector has a variable.
  bool is_variable(lanes::VectorId id) const { return is_variable_[id] != 0; }
  std::string name(lanes::VectorId id) const { return names_[id]; }
  std::string type() const { return with_width(language_.vectors.type); }
  std::string lane(lanes::Lane const &lane) const;
  std::string store(lanes::Store const &store, std::string const &array) const;
  // Value of a vector's variable. `use`: spelling of a node that is scalar or a leaf. Adds the nodes that the text
  // computes to `computed`.
  std::string value(lanes::VectorId id, std::function<std::string(NodeId)> const &use,
                    std::vector<NodeId> &computed) const;
  // All names that the text may use.
  std::set<std::string> names() const;

private:
  // Text and its binding strength; 0: needs no parentheses.
  struct Text {
    std::string text;
    int precedence = 0;
  };
  class Printer;

  void choose_variables();
  std::string with_width(std::string_view pattern) const;

  Emission const &emission_;
  Language const &language_;
  lanes::LaneFunction const &function_;
  std::vector<char> is_variable_;
  std::vector<std::string> names_; // per vector that is a variable
};

} // namespace symreal
