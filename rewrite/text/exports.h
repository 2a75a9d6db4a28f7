// Rewritten files for other tools: beside the user's tree, or as the edits that Clang's tools exchange.
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

// The YAML that clang-apply-replacements reads.
std::string fixes_yaml(std::vector<File> const &files);

} // namespace symreal::rewrite
