#include "rewrite/source/lookups.h"

#include "rewrite/request/request.h"

#include <llvm/ADT/StringExtras.h>

#include <algorithm>
#include <array>

namespace symreal::rewrite {
namespace {

namespace vfs = llvm::vfs;
using llvm::ErrorOr;
using llvm::StringRef;
using llvm::Twine;

constexpr char const *nothing = "-", *changed = "changed while it was read"; // the latter is never an answer now

std::string status_answer(ErrorOr<vfs::Status> const &status) {
  if (!status) return nothing;
  return status->isDirectory() ? "d" : "f";
}

std::string listing_answer(vfs::FileSystem &disk, Twine const &path) {
  std::vector<std::string> names;
  std::error_code error;
  for (vfs::directory_iterator at = disk.dir_begin(path, error), end; !error && at != end; at.increment(error))
    names.push_back(at->path().str());
  if (error) return nothing;
  std::sort(names.begin(), names.end());
  return content_id(llvm::join(names, StringRef("\0", 1)));
}

std::string real_path_answer(vfs::FileSystem &disk, Twine const &path) {
  llvm::SmallString<256> real;
  return disk.getRealPath(path, real) ? nothing : real.str().str();
}

std::string text_answer(ErrorOr<std::unique_ptr<llvm::MemoryBuffer>> const &text) {
  return text ? content_id((*text)->getBuffer()) : nothing;
}

// A file whose contents are written down as they are read: it may be changed a moment later.
class WatchedFile : public vfs::File {
public:
  WatchedFile(std::unique_ptr<vfs::File> file, std::string &answer) : file_(std::move(file)), answer_(answer) {}
  ErrorOr<vfs::Status> status() override { return file_->status(); }
  ErrorOr<std::string> getName() override { return file_->getName(); }
  ErrorOr<std::unique_ptr<llvm::MemoryBuffer>> getBuffer(Twine const &name, std::int64_t size, bool terminated,
                                                         bool is_volatile) override {
    auto text = file_->getBuffer(name, size, terminated, is_volatile);
    std::string const now = text_answer(text);
    answer_ = answer_.empty() || answer_ == now ? now : changed;
    return text;
  }
  std::error_code close() override { return file_->close(); }

private:
  std::unique_ptr<vfs::File> file_;
  std::string &answer_; // a map keeps its place
};

class WatchedDisk : public vfs::ProxyFileSystem {
public:
  explicit WatchedDisk(Lookups &lookups)
      : ProxyFileSystem(vfs::createPhysicalFileSystem().release()),
        lookups_(lookups) {}

  ErrorOr<vfs::Status> status(Twine const &path) override {
    auto found = ProxyFileSystem::status(path);
    lookups_[question('s', path)] = status_answer(found);
    return found;
  }
  bool exists(Twine const &path) override { return static_cast<bool>(status(path)); }
  ErrorOr<std::unique_ptr<vfs::File>> openFileForRead(Twine const &path) override {
    std::string &real = lookups_[question('r', path)];
    if (real.empty()) real = real_path_answer(getUnderlyingFS(), path);
    std::string &text = lookups_[question('t', path)];
    auto file = ProxyFileSystem::openFileForRead(path);
    if (!file) return text = nothing, file.getError();
    return std::make_unique<WatchedFile>(std::move(*file), text);
  }
  vfs::directory_iterator dir_begin(Twine const &path, std::error_code &error) override {
    lookups_[question('l', path)] = listing_answer(getUnderlyingFS(), path);
    return ProxyFileSystem::dir_begin(path, error);
  }
  std::error_code getRealPath(Twine const &path, llvm::SmallVectorImpl<char> &real) override {
    std::error_code const error = ProxyFileSystem::getRealPath(path, real);
    lookups_[question('r', path)] = error ? nothing : std::string(real.data(), real.size());
    return error;
  }

private:
  std::string question(char kind, Twine const &path) const {
    llvm::SmallString<256> absolute;
    path.toVector(absolute);
    if (getUnderlyingFS().makeAbsolute(absolute)) absolute.assign(path.str()); // asked for as it is
    return std::string(1, kind) + absolute.str().str();
  }
  Lookups &lookups_;
};

} // namespace

FileSystem watched_disk(Lookups &lookups) { return new WatchedDisk(lookups); }

std::string const &DiskNow::answer(std::string const &question) {
  {
    std::lock_guard const lock(mutex_);
    if (auto const known = answers_.find(question); known != answers_.end()) return known->second;
  }
  vfs::FileSystem &disk = *vfs::getRealFileSystem();
  std::string const path = question.substr(1);
  std::string answer;
  switch (question[0]) {
  case 's': answer = status_answer(disk.status(path)); break;
  case 't': answer = text_answer(disk.getBufferForFile(path)); break;
  case 'l': answer = listing_answer(disk, path); break;
  default: answer = real_path_answer(disk, path); break;
  }
  std::lock_guard const lock(mutex_);
  return answers_.try_emplace(question, std::move(answer)).first->second;
}

bool DiskNow::still_answers(Lookups const &lookups) {
  return std::all_of(lookups.begin(), lookups.end(),
                     [&](auto const &one) { return one.second.empty() || answer(one.first) == one.second; });
}

} // namespace symreal::rewrite
