// Overlay of rewritten files, which a compiler finds instead of the originals, with the map back to source places.
//
// A file with real path P stands at <directory>/P. It begins with a #line directive that restores its name and its line
// numbers, so only columns differ from the original, and those follow from the edits.
#pragma once

#include "rewrite/rewrite.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace symreal::program {

class Overlay {
public:
  // Overlay of a program built elsewhere: all files count as rewritten except the system's and Symreal's, and columns
  // are unknown.
  Overlay() = default;
  // Writes the files below `directory`. Definitions in C sources (real paths) and their headers keep C linkage, though
  // they are compiled as C++.
  Overlay(rewrite::Result const &rewritten, std::string directory, std::set<std::string> c_sources = {});

  // Path of the rewritten text of a source.
  std::string compiled_path(std::string const &source) const;
  // The flags of a source whose compiler runs in `directory` (empty: the current one), with the counterpart of each
  // search directory before it, so that the search order stays, and with the counterpart of each -include header.
  // Compiled files of the overlay have the names of the originals.
  std::vector<std::string> search_flags(std::vector<std::string> const &flags, std::string const &directory = {}) const;

  // Is this the name of a rewritten file, as the user or an #include spells it?
  bool contains(std::string const &file) const;
  // Maps a place reported by the compiler or the debug information to the user's source.
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
  std::map<std::string, std::size_t> by_name_; // index by display path and real path
};

// Maps a place in the rewritten text of a file to its original text.
Place original_place(rewrite::File const &file, Place place);

// Links each neighbour of a rewritten file beside its copy, which lies at `top` followed by its real path, so that an
// #include in quotes finds it.
void link_neighbours(rewrite::Result const &rewritten, std::string const &top);

// Inserts the counterpart of each search directory, if any, before it, so that the search order stays, and the
// counterpart of each -include header. `searched` receives the directories as the flags name them.
std::vector<std::string>
search_flags(std::vector<std::string> const &flags,
             std::function<std::optional<std::string>(std::string const &name)> const &counterpart,
             std::vector<std::string> &searched);

} // namespace symreal::program
