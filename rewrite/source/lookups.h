// Record of a reading's questions to the disk, with the answers: facts may be reused only if the same questions still
// get the same answers.
//
// Clang sees the disk through this file system, so the record is complete: missing files (a header in a directory that
// is searched earlier), directories, links, look-ups of Clang's driver.
#pragma once

#include "rewrite/source/clang.h"

#include <llvm/Support/VirtualFileSystem.h>

#include <map>
#include <mutex>
#include <string>

namespace symreal::rewrite {

// Questions and answers. A question is a letter and an absolute path: s(tatus), t(ext), l(isting), r(eal path). The
// answer is empty for a text that was opened and never read.
using Lookups = std::map<std::string, std::string>;

using FileSystem = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

// The disk, with a working directory of its own; records all questions. Not thread-safe.
FileSystem watched_disk(Lookups &lookups);

// The disk's present answers. Each question is asked once; thread-safe.
class DiskNow {
public:
  bool still_answers(Lookups const &lookups);

private:
  std::string const &answer(std::string const &question);

  std::mutex mutex_;
  std::map<std::string, std::string> answers_;
};

} // namespace symreal::rewrite
