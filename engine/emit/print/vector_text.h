// Vectors as text: nested like numbers, with what is used more than once in variables.
#pragma once

#include "engine/emit/print/emission.h"

#include <functional>
#include <string>
#include <vector>

namespace symreal {

class VectorText {
public:
  VectorText(Emission const &emission, lanes::LaneFunction const &function);

  // Whether the vector is a variable of its own.
  bool is_variable(lanes::VectorId id) const { return is_variable_[id] != 0; }
  std::string name(lanes::VectorId id) const { return names_[id]; }
  std::string type() const { return with_width(language_.vectors.type); }
  std::string lane(lanes::Lane const &lane) const;
  std::string store(lanes::Store const &store, std::string const &array) const;
  // The value of a variable. `use`: how a node that is computed alone is spelled, or is no operation. The nodes that
  // the text computes are added to `computed`.
  std::string value(lanes::VectorId id, std::function<std::string(NodeId)> const &use,
                    std::vector<NodeId> &computed) const;
  // All names that the text may have.
  std::set<std::string> names() const;

private:
  // Text, and how tightly it binds; 0: needs no parentheses.
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
