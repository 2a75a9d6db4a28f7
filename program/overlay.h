// The rewritten files, laid out so that a compiler finds them instead of the originals, and the way back from a place
// in them to the place in the source.
//
// A file with real path P stands at <directory>/P. It begins with a #line directive that restores its name and its line
// numbers, so only columns differ from the original, and those follow from the edits.
#pragma once

#include "rewrite/rewrite.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

class Overlay {
public:
  // Writes the files below `directory`.
  Overlay(rewrite::Result const &rewritten, std::string directory);

  // Where the rewritten text of a source stands.
  std::string compiled_path(std::string const &source) const;
  // To stand before the user's own flags, so that rewritten headers are found first.
  std::vector<std::string> include_flags() const;

  // True for the name (as the user or an #include spells it) of a rewritten file.
  bool contains(std::string const &file) const { return find(file) != nullptr; }
  // A place as the compiler or the debug information of the rewritten program tells it, in the user's source.
  Place original(Place place) const;

private:
  rewrite::File const *find(std::string const &file) const;

  std::string directory_;
  std::vector<rewrite::File> files_;
  std::vector<std::string> include_dirs_;
  std::map<std::string, std::size_t> by_name_; // display path and real path to index
};

} // namespace symreal::program
