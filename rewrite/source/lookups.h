// What a reading asked the disk, and what the disk said: the same questions must get the same answers before what the
// reading found can be taken for what it would find now.
//
// Clang sees the disk through a file system of ours, so nothing is left out: files that are not there (a header in a
// directory that is searched earlier), directories, links, what Clang's driver looks for.
#pragma once

#include "rewrite/source/clang.h"

#include <llvm/Support/VirtualFileSystem.h>

#include <map>
#include <mutex>
#include <string>

namespace symreal::rewrite {

// A question, asked of an absolute path, begins with a letter: s(tatus), t(ext), l(isting), r(eal path). The answer is
// empty for a text that was opened and never read.
using Lookups = std::map<std::string, std::string>;

using FileSystem = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

// The disk, with a working directory of its own; writes down all that is asked. One thread uses it.
FileSystem watched_disk(Lookups &lookups);

// What the disk says now. Each question is asked once; several threads may.
class DiskNow {
public:
  bool still_answers(Lookups const &lookups);

private:
  std::string const &answer(std::string const &question);

  std::mutex mutex_;
  std::map<std::string, std::string> answers_;
};

// What the contents of a file are known by.
std::string content_id(llvm::StringRef text);

} // namespace symreal::rewrite
