// Strict YAML reader: every value has the expected form, every key is known, and errors have a place.
#pragma once

#include "engine/diagnostics/diagnostic.h"
#include "rewrite/rewrite.h"

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace symreal::tool {

class Yaml {
public:
  Yaml(std::string file, YAML::Node const &node) : file_(std::move(file)), node_(node) {}

  Place place() const;
  [[noreturn]] void fail(std::string const &message) const {
    symreal::fail(DiagnosticId::configuration, place(), message);
  }
  bool is_map() const { return node_.IsMap(); }
  bool is_list() const { return node_.IsSequence(); }

  rewrite::ConfiguredText text() const;
  bool truth() const;
  // Elements of a list; a single value counts as a list of one.
  std::vector<Yaml> list() const;
  // Entries of a map, in the order of the file. A duplicate key is an error.
  struct Entry;
  std::vector<Entry> entries() const;

private:
  std::string file_;
  YAML::Node node_;
};

struct Yaml::Entry {
  rewrite::ConfiguredText key;
  Yaml value;
};

// Reads the document in a file. Throws configuration or unreadable_file.
Yaml read_yaml(std::string const &file);

} // namespace symreal::tool
