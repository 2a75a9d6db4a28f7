// The rewritten files beside the user's tree.
#pragma once

#include "rewrite/facts/result.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

struct MirrorFile {
  std::string path, text;
};

// The mirror of the files under `directory`, each at its path below `top` or, if that is empty, below the deepest
// directory that all share. All files must lie below `top`, a real path. Every file begins with a #line directive, so
// that places and assertions keep their names.
std::vector<MirrorFile> mirror(std::vector<File> const &files, std::string const &directory,
                               std::string const &top = {});

} // namespace symreal::rewrite
