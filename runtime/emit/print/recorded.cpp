#include "emit/print/recorded.h"

#include "graph/names.h"

namespace symreal {

std::vector<std::string> output_names(Emission const &emission) {
  std::vector<Object> const &outputs = emission.graph().outputs;
  std::vector<std::string> const objects = identifiers(outputs, emission.language.names);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    for (std::uint32_t k = 0; k < outputs[i].count; ++k) names.push_back(element_name(objects[i], outputs[i], k));
  return names;
}

std::vector<std::string> constants(Language const &language, std::vector<double> const &values) {
  std::vector<std::string> texts;
  for (double const value : values) texts.push_back(constant(language, value));
  return texts;
}

} // namespace symreal
