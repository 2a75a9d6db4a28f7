#include "program/build/read_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/openat2.h>
#include <linux/seccomp.h>
#include <mutex>
#include <poll.h>
#include <set>
#include <string_view>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;

struct Known {
  std::mutex mutex;
  std::set<std::string> read, written, absent; // absolute paths
  bool are_all = true;
};

// Never destroyed: threads may outlive static objects.
Known &known() {
  static auto *const files = new Known;
  return *files;
}

void note(std::set<std::string> Known::*set, std::string const &path) {
  std::error_code error;
  fs::path name = fs::absolute(path, error);
  // Resolves links first if the path has "..", which behind a link leads elsewhere.
  bool const goes_up = std::find(name.begin(), name.end(), "..") != name.end();
  name = goes_up ? fs::weakly_canonical(name.parent_path(), error) / name.filename() : name.lexically_normal();
  if (error) return;
  std::string absolute = name.string();
  std::lock_guard const lock(known().mutex);
  (known().*set).insert(std::move(absolute));
}

// Is this a pseudo file of the system, or one that changes all the time?
bool is_of_system(std::string const &path) {
  for (char const *start : {"/proc/", "/sys/", "/dev/", "/etc/ld.so.cache"})
    if (path.starts_with(start)) return true;
  return false;
}

// Notes a file that a program opened with these `flags` of open(2). A file that it writes before reading is its own.
// After a failed lookup the file's appearance would change the result.
void note_opened(std::string const &path, int flags) {
  struct stat status{};
  bool const exists = stat(path.c_str(), &status) == 0;
  if (is_of_system(path) || (exists && !S_ISREG(status.st_mode))) return;
  bool const writes = (flags & O_ACCMODE) != O_RDONLY, is_own = [&] {
    std::lock_guard const lock(known().mutex);
    return known().written.contains(path);
  }();
  bool const reads = (flags & O_ACCMODE) != O_WRONLY && exists && (flags & O_TRUNC) == 0;
  if (reads && !is_own) note(&Known::read, path);
  if (writes) note(&Known::written, path);
  if (!exists && !writes && !is_own) note(&Known::absent, path);
}

#if defined(__x86_64__)
constexpr unsigned own_architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned own_architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned own_architecture = 0;
#endif

#if defined(SYS_open)
constexpr unsigned plain_open = SYS_open;
#else
constexpr unsigned plain_open = SYS_openat; // the only call that opens files
#endif

// Filter that notifies the listener of the calls of this architecture that open files.
constexpr std::array filter = {
    sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
    sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own_architecture, 0, 4),
    sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
    sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 3, 0),
    sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat2, 2, 0),
    sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, plain_open, 1, 0),
    sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
};

// A one-byte message that carries a descriptor.
struct Parcel {
  char byte = 0;
  iovec part = {&byte, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};

  Parcel() {
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
  }
};

void send_descriptor(int socket, int descriptor) {
  Parcel parcel;
  cmsghdr *const header = CMSG_FIRSTHDR(&parcel.message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof descriptor);
  std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  (void)!sendmsg(socket, &parcel.message, 0);
}

int received_descriptor(int socket) {
  Parcel parcel;
  ssize_t got = 0;
  while ((got = recvmsg(socket, &parcel.message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  cmsghdr const *const header = got == 1 ? CMSG_FIRSTHDR(&parcel.message) : nullptr;
  if (!header || header->cmsg_type != SCM_RIGHTS) return -1;
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(header), sizeof descriptor);
  return descriptor;
}

// Reads memory of the other process; returns fewer bytes at the end of its mapping.
std::size_t read_memory(pid_t process, std::uint64_t address, void *to, std::size_t size) {
  iovec const here = {to, size}, there = {reinterpret_cast<void *>(address), size};
  ssize_t const got = process_vm_readv(process, &here, 1, &there, 1, 0);
  return got < 0 ? 0 : static_cast<std::size_t>(got);
}

std::string text_at(pid_t process, std::uint64_t address) {
  constexpr std::size_t page = 4096;
  std::string text;
  std::array<char, page> piece;
  while (text.size() < PATH_MAX) {
    std::size_t const got = read_memory(process, address, piece.data(), page - address % page);
    std::string_view const read(piece.data(), got);
    text += read.substr(0, read.find('\0'));
    if (got == 0 || read.find('\0') != read.npos) break;
    address += got;
  }
  return text;
}

std::string link_of(pid_t process, std::string const &name) {
  std::error_code error;
  return fs::read_symlink("/proc/" + std::to_string(process) + "/" + name, error).string();
}

void tell(seccomp_notif const &asked) {
  auto const process = static_cast<pid_t>(asked.pid);
  auto const &arguments = asked.data.args;
  bool const is_at = asked.data.nr == SYS_openat || asked.data.nr == SYS_openat2;
  int const directory = is_at ? static_cast<int>(arguments[0]) : AT_FDCWD;
  std::string const name = text_at(process, arguments[is_at ? 1 : 0]);
  int flags = static_cast<int>(arguments[is_at ? 2 : 1]);
  open_how how{};
  if (asked.data.nr == SYS_openat2 && read_memory(process, arguments[2], &how.flags, sizeof how.flags) != 0)
    flags = static_cast<int>(how.flags);
  if (name.empty()) return;
  fs::path const start =
      name[0] == '/' ? "/" : link_of(process, directory == AT_FDCWD ? "cwd" : "fd/" + std::to_string(directory));
  note_opened((start / name).string(), flags);
}

// Message sizes: the kernel's may exceed those of the headers.
struct Sizes {
  std::size_t question = sizeof(seccomp_notif), answer = sizeof(seccomp_notif_resp);
  Sizes() {
    seccomp_notif_sizes sizes{};
    if (syscall(SYS_seccomp, SECCOMP_GET_NOTIF_SIZES, 0, &sizes) != 0) return;
    question = std::max<std::size_t>(question, sizes.seccomp_notif);
    answer = std::max<std::size_t>(answer, sizes.seccomp_notif_resp);
  }
};

void serve_all(int listener) {
  Sizes const sizes;
  std::vector<std::uint64_t> question(sizes.question / sizeof(std::uint64_t) + 1);
  std::vector<std::uint64_t> answer(sizes.answer / sizeof(std::uint64_t) + 1);
  for (;;) {
    pollfd wanted = {listener, POLLIN, 0};
    if (poll(&wanted, 1, -1) < 0 && errno != EINTR) break;
    if (wanted.revents & (POLLHUP | POLLERR)) break;
    if (!(wanted.revents & POLLIN)) continue;
    std::ranges::fill(question, 0);
    std::ranges::fill(answer, 0);
    auto *const asked = reinterpret_cast<seccomp_notif *>(question.data());
    auto *const answered = reinterpret_cast<seccomp_notif_resp *>(answer.data());
    if (ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, asked) != 0) continue; // the process has been killed meanwhile
    tell(*asked);
    answered->id = asked->id;
    answered->flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
    ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, answered);
  }
  close(listener);
}

} // namespace

void note_read(std::string const &path) { note(&Known::read, path); }

std::string identity_of(std::string const &path) {
  struct stat status{};
  if (stat(path.c_str(), &status) == 0) return fmt::format("{}:{}", status.st_dev, status.st_ino);
  std::error_code error;
  fs::path const absolute = fs::absolute(path, error);
  fs::path const directory = fs::canonical(absolute.parent_path(), error);
  return (error ? absolute.lexically_normal() : directory / absolute.filename()).string();
}

std::optional<std::string> known_as(std::string const &path) {
  std::string const wanted = identity_of(path);
  std::lock_guard const lock(known().mutex);
  for (auto const *set : {&known().read, &known().written})
    for (std::string const &one : *set)
      if (identity_of(one) == wanted) return one;
  return {};
}

ReadFiles files_read() {
  std::lock_guard const lock(known().mutex);
  return {{known().read.begin(), known().read.end()}, {known().absent.begin(), known().absent.end()}, known().are_all};
}

OpenedFiles::OpenedFiles() {
  if (own_architecture == 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_) != 0) ends_[0] = ends_[1] = -1;
}

OpenedFiles::~OpenedFiles() {
  for (int const end : ends_)
    if (end >= 0) close(end);
}

void OpenedFiles::install() const noexcept {
  if (ends_[1] < 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  sock_fprog const program = {filter.size(), const_cast<sock_filter *>(filter.data())};
  long const listener = syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &program);
  if (listener < 0) return;
  send_descriptor(ends_[1], static_cast<int>(listener));
  close(static_cast<int>(listener));
}

void OpenedFiles::serve() {
  if (ends_[1] >= 0) close(std::exchange(ends_[1], -1));
  int const listener = ends_[0] < 0 ? -1 : received_descriptor(ends_[0]);
  if (listener < 0) { // the system does not support it
    std::lock_guard const lock(known().mutex);
    known().are_all = false;
    return;
  }
  // Detached: background processes that the program leaves are still served.
  std::thread(serve_all, listener).detach();
}

} // namespace symreal::program
