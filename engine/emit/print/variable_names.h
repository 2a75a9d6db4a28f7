// Identifiers for the variables of a generated function.
#pragma once

#include "engine/emit/print/emission.h"

#include <string>
#include <vector>

namespace symreal {

// What the source calls the value, numbered from the second of a name on; t and its number where it has no name.
// Different from each other and from what else the generated functions use. Takes 8 bytes a variable.
class VariableNames {
public:
  VariableNames(Emission const &emission, FunctionBody const &body);

  void append_to(std::string &text, std::size_t variable) const;
  std::string operator()(std::size_t variable) const;

private:
  struct Entry {
    NameId name;
    std::uint32_t number;
  };
  void append_name(std::string &text, std::size_t variable) const;

  NameRules const *rules_;
  std::string (*written_)(std::string const &);
  std::vector<std::string> bases_; // per name of the graph
  std::vector<Entry> entries_;     // per variable; empty where nothing has a name
};

} // namespace symreal
