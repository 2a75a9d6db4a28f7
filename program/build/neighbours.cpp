#include "program/build/neighbours.h"

#include <filesystem>
#include <set>

namespace symreal::program {

namespace fs = std::filesystem;

void link_neighbours(rewrite::Result const &rewritten, std::string const &top) {
  std::set<fs::path> directories;
  for (rewrite::File const &file : rewritten.files) directories.insert(fs::path(file.path).parent_path());
  for (fs::path const &directory : directories) {
    std::error_code unreadable, exists;
    for (fs::directory_entry const &one : fs::directory_iterator(directory, unreadable))
      fs::create_symlink(one.path(), top + one.path().string(), exists);
  }
}

} // namespace symreal::program
