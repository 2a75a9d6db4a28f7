#include "engine/emit/print/recorded.h"

#include "engine/graph/names.h"

namespace symreal {

std::vector<std::string> output_names(Emission const &emission) {
  return element_names(emission.graph().outputs, emission.language.names);
}

std::vector<std::string> constants(Language const &language, std::vector<double> const &values) {
  std::vector<std::string> texts;
  for (double const value : values) texts.push_back(constant(language, value));
  return texts;
}

} // namespace symreal
