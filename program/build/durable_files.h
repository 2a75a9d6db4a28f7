// File operations that are on disk when they return, transactions on several files, and content hashes.
#pragma once

#include "program/build/interruption.h"

#include <string>
#include <vector>

namespace symreal::program {

// These functions throw unwritable_output.
void write_durably(std::string const &path, std::string const &text, unsigned permissions);
void rename_durably(std::string const &from, std::string const &to);
void remove_durably(std::string const &path); // no effect if the file does not exist

// Files that appear together or not at all. Each is written to disk under a temporary name beside its own before the
// first one is renamed; if a rename fails, earlier ones are reverted. Files that are not committed are removed, also
// when a signal ends the tool. A kill between two renames breaks the guarantee: use a journal (tree_edit.h) to survive
// that.
class StagedFiles {
public:
  StagedFiles() = default;
  ~StagedFiles();
  StagedFiles(StagedFiles const &) = delete;
  StagedFiles &operator=(StagedFiles const &) = delete;

  // Creates the directory and its missing parents.
  void make_directory(std::string const &path);
  // Stages a file. A file with the same text is left alone, so that its time stamp causes no rebuild.
  void add(std::string const &path, std::string const &text);
  // Stages a directory, which must be absent or empty. Returns the temporary directory to fill by write_durably.
  std::string add_directory(std::string const &path);
  void commit();

private:
  struct StagedFile {
    std::string temporary, path;
    Doomed doomed;
    std::string old = {}; // hard link to the file that was replaced
    bool is_done = false;
  };
  static void take_place(StagedFile &step);
  static void take_back(StagedFile &step) noexcept;

  std::vector<StagedFile> steps_;
  std::vector<std::string> made_; // created directories, outermost first
};

// Permissions of a new file under the umask.
unsigned usual_permissions();

// SHA-256, in hexadecimal digits.
std::string content_hash(std::string const &text);
// content_hash of the file; empty if it cannot be read.
std::string file_hash(std::string const &path);

} // namespace symreal::program
