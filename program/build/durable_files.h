// File operations that have reached the disk when they return, and what a file's content is known by.
#pragma once

#include "program/build/interruption.h"

#include <string>
#include <vector>

namespace symreal::program {

// All throw unwritable_output.
void write_durably(std::string const &path, std::string const &text, unsigned permissions);
void rename_durably(std::string const &from, std::string const &to);
void remove_durably(std::string const &path); // does nothing if it is not there

// Files that appear together or not at all. Each lies complete on the disk under a temporary name beside its own before
// the first takes its name; where one cannot, those before it get their old contents back. What is not committed leaves
// nothing behind, also when a signal ends the tool. A kill between two renames is the exception: what must survive
// that keeps a journal (tree_edit.h).
// All functions throw unwritable_output.
class StagedFiles {
public:
  StagedFiles() = default;
  ~StagedFiles();
  StagedFiles(StagedFiles const &) = delete;
  StagedFiles &operator=(StagedFiles const &) = delete;

  // Makes the directory, and those above it, where there are none.
  void make_directory(std::string const &path);
  // A file that holds the text already is left alone, so that its time stamp causes no rebuild.
  void add(std::string const &path, std::string const &text);
  // A directory that is not there, or is empty. Returns the one to fill in its place by write_durably.
  std::string add_directory(std::string const &path);
  void commit();

private:
  struct Step {
    std::string temporary, path;
    Doomed doomed;
    std::string old = {}; // a second name of what stood at the path
    bool is_done = false;
  };
  static void take_place(Step &step);
  static void take_back(Step &step) noexcept;

  std::vector<Step> steps_;
  std::vector<std::string> made_; // directories, the outer ones first
};

// The permissions that any new file gets.
unsigned usual_permissions();

// SHA-256, in hexadecimal digits.
std::string content_hash(std::string const &text);
// Of the file; empty if it cannot be read.
std::string file_hash(std::string const &path);

} // namespace symreal::program
