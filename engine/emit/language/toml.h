// The part of TOML 1.0 in which languages are written: tables, and as values texts, whole numbers, truth values, lists
// and inline tables.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace symreal {

struct TomlValue {
  using List = std::vector<TomlValue>;
  std::variant<std::string, std::int64_t, bool, List> value;
};

// A value under the names of its tables and its key: "module.places.object".
struct TomlEntry {
  std::string path;
  TomlValue value;
  std::string_view file;
  unsigned line = 0;
};

// The entries in their order. What is wrong is told with its line, as table_fault does.
std::vector<TomlEntry> read_toml(std::string_view file, std::string_view text);

[[noreturn]] void table_fault(std::string_view file, unsigned line, std::string const &what);

} // namespace symreal
