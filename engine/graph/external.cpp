#include "engine/graph/external.h"

namespace symreal {

std::size_t External::argument_count() const {
  std::size_t count = 0;
  for (ExternalValue const &parameter : parameters)
    if (parameter.is_given()) count += parameter.count;
  return count;
}

std::size_t External::result_count() const {
  std::size_t count = returned_count();
  for (ExternalValue const &parameter : parameters)
    if (parameter.kind == ExternalValue::Kind::output || parameter.kind == ExternalValue::Kind::updated)
      count += parameter.count;
  return count;
}

bool External::takes_integer(std::size_t argument) const {
  for (ExternalValue const &parameter : parameters) {
    if (!parameter.is_given()) continue;
    if (argument < parameter.count) return parameter.kind == ExternalValue::Kind::integer;
    argument -= parameter.count;
  }
  return false;
}

std::vector<std::size_t> External::number_arguments() const {
  std::vector<std::size_t> numbers;
  std::size_t const count = argument_count();
  for (std::size_t argument = 0; argument < count; ++argument)
    if (!takes_integer(argument)) numbers.push_back(argument);
  return numbers;
}

std::optional<External> External::derivative() const {
  using Kind = ExternalValue::Kind;
  if (derivatives.empty()) return std::nullopt;
  External result{derivatives.front().name, pure, {}, {}, place, {derivatives.begin() + 1, derivatives.end()}};
  for (ExternalValue parameter : parameters) {
    if (!parameter.is_given()) continue;
    if (parameter.kind == Kind::updated) parameter.kind = Kind::input;
    result.parameters.push_back(parameter);
  }
  auto const partials = static_cast<std::uint32_t>(result_count() * number_arguments().size());
  if (derivatives.front().is_returned)
    result.returned.kind = Kind::number;
  else
    result.parameters.push_back({Kind::output, partials});
  return result;
}

} // namespace symreal
