// Temporary directory of a run, outside the user's tree. It is removed at the end of the run, also on interruption,
// unless it is to be kept; the next run removes that of a killed run.
#pragma once

#include "program/build/interruption.h"

#include <string>

namespace symreal::program {

class Workspace {
public:
  explicit Workspace(bool keep);
  ~Workspace();
  Workspace(Workspace const &) = delete;
  Workspace &operator=(Workspace const &) = delete;

  std::string const &path() const { return path_; }
  std::string file(std::string const &name) const { return path_ + "/" + name; }
  // Creates the directory `name` and returns its path.
  std::string directory(std::string const &name) const;

private:
  std::string path_;
  bool keep_;
  int lock_ = -1; // locked while the run lives
  Doomed doomed_;
};

} // namespace symreal::program
