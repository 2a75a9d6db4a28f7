// A directory of its own for what one run builds, outside the user's tree. It disappears at the end of the run, also
// when the run is interrupted, unless it is to be kept; one of a run that was killed disappears with the next run.
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
  // Makes the directory `name` and returns its path.
  std::string directory(std::string const &name) const;

private:
  std::string path_;
  bool keep_;
  int lock_ = -1; // held as long as the run lives
  Doomed doomed_;
};

} // namespace symreal::program
