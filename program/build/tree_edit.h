// Replaces files of the user's tree: all of them or none, also when the process is killed, and so that it can be
// undone.
//
// Everything about it lies in a directory `.symreal`, N counting the edits:
//
//   prepared.json ──the commit: rename──▶ committed.json ──files renamed──▶ N.json
//   the originals in N/, the new texts beside the files
//
// A process that finds prepared.json takes the edit back, one that finds committed.json completes it. An undo is an
// edit whose new texts are the originals; at its end N.json and N/ go.
#pragma once

#include <string>
#include <vector>

namespace symreal::program {

struct Replacement {
  std::string path;     // real path
  std::string original; // what must still stand there
  std::string text;
};

// Throws before anything is written if a file changed, is read-only or has further names; nothing happens if there are
// no replacements. Returns the directory that can be undone.
std::string edit_tree(std::vector<Replacement> const &replacements);

enum class Recovery {
  nothing,
  completed,  // an edit that was committed
  taken_back, // one that was not
  undone,     // an undo that was committed was completed
  not_undone, // one that was not was taken back
};

// Looks for an interrupted edit in the directory and those above it. Throws if another process is at work there.
Recovery recover_tree(std::string const &directory);

// Takes the last edit back, after a recovery; returns the files. Throws undo_refused if there is none or a file changed
// since.
std::vector<std::string> undo_tree(std::string const &directory);

} // namespace symreal::program
