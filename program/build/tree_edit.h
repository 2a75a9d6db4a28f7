// Atomic, undoable replacement of files of the user's tree: all of them or none, even if the process is killed.
//
// The state lies in a directory `.symreal`; N counts the edits:
//
//   prepared.json ──the commit: rename──▶ committed.json ──files renamed──▶ N.json
//   the originals in N/, the new texts beside the files
//
// A process that finds prepared.json reverts the edit, one that finds committed.json completes it. An undo is an edit
// whose new texts are the originals; its end removes N.json and N/.
#pragma once

#include <string>
#include <vector>

namespace symreal::program {

struct Replacement {
  std::string path;     // real path
  std::string original; // expected current text
  std::string text;
};

// Throws before any write if a file changed, is read-only or has several hard links. No effect without replacements.
// Returns the directory to undo from.
std::string edit_tree(std::vector<Replacement> const &replacements);

enum class Recovery {
  nothing,
  completed,  // completed a committed edit
  taken_back, // reverted an uncommitted edit
  undone,     // completed a committed undo
  not_undone, // reverted an uncommitted undo
};

// Recovers an interrupted edit in the directory or a parent. Throws if another process is at work there.
Recovery recover_tree(std::string const &directory);

// Reverts the last edit, after a recovery; returns the files. Throws undo_refused without an edit, or if a file changed
// since.
std::vector<std::string> undo_tree(std::string const &directory);

} // namespace symreal::program
