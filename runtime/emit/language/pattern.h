// Patterns of text in the tables of languages: "$type $name = $value;" with the places filled.
#pragma once

#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace symreal {

// Replaces each $name, or ${name} before a letter, by its value, and $$ by $. A name without a value is a fault of the
// table.
std::string fill(std::string_view pattern, std::span<std::pair<std::string_view, std::string_view> const> values);
inline std::string fill(std::string_view pattern,
                        std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  return fill(pattern, std::span(values.begin(), values.size()));
}

// Values that are kept, in the three cases of names: name, Name, NAME.
class Filling {
public:
  Filling &set(std::string const &name, std::string value) {
    values_.insert_or_assign(name, std::move(value));
    return *this;
  }
  Filling &set(std::string const &name, std::size_t value) { return set(name, std::to_string(value)); }
  // `joins`: a_name becomes AName, otherwise A_name.
  Filling &set_name(std::string const &name, std::string const &value, bool joins = true);
  std::string operator()(std::string_view pattern) const;

private:
  std::map<std::string, std::string> values_;
};

} // namespace symreal
