// The rewritten files, laid out so that a compiler finds them instead of the originals, and the way back from a place
// in them to the place in the source.
//
// A file with real path P stands at <directory>/P. It begins with a #line directive that restores its name and its line
// numbers, so only columns differ from the original, and those follow from the edits.
#pragma once

#include "rewrite/rewrite.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::program {

class Overlay {
public:
  // Of a program that was built elsewhere: every file counts as rewritten but those of the system and Symreal's own,
  // and columns are not known.
  Overlay() = default;
  // Writes the files below `directory`. What the sources in C (real paths) and their headers define keeps C linkage,
  // though they are compiled as C++.
  Overlay(rewrite::Result const &rewritten, std::string directory, std::set<std::string> c_sources = {});

  // Where the rewritten text of a source stands.
  std::string compiled_path(std::string const &source) const;
  // The flags of a source whose compiler runs in `directory` (empty: that of this process) with the counterpart of each
  // search directory before it, so that the order of the search stays, and with that of each header that they include.
  // In what is compiled, the files of the overlay have the names of the originals.
  std::vector<std::string> search_flags(std::vector<std::string> const &flags, std::string const &directory = {}) const;

  // True for the name (as the user or an #include spells it) of a rewritten file.
  bool contains(std::string const &file) const;
  // A place as the compiler or the debug information of the rewritten program tells it, in the user's source.
  Place original(Place place) const;

private:
  rewrite::File const *find(std::string const &file) const;
  std::string redirected(std::string const &text) const;
  std::optional<std::string> counterpart(std::string const &name) const;
  void write(rewrite::File const &file) const;

  std::string directory_;
  std::vector<rewrite::File> files_;
  std::vector<std::string> include_dirs_;
  std::set<std::string> c_sources_;
  std::map<std::string, std::size_t> by_name_; // display path and real path to index
};

// A place in the rewritten text of the file, in its original text.
Place original_place(rewrite::File const &file, Place place);

} // namespace symreal::program
