// Entries of a TOML file, in the order of the file and with their lines. Values are texts, whole numbers, truth values
// and lists of these.
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

// A fault of the file is an exception with its line, as by table_fault.
std::vector<TomlEntry> read_toml(std::string_view file, std::string_view text);

[[noreturn]] void table_fault(std::string_view file, unsigned line, std::string const &what);

} // namespace symreal
