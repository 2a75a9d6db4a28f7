#include "runtime/trace/decisions/arms.h"

#include "engine/support/files.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::trace {
namespace {

constexpr int files_of_program = 1000;

bool read_whole(int file, void *begin, std::size_t size) {
  auto *next = static_cast<char *>(begin);
  while (size != 0) {
    ssize_t const got = read(file, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

void close_one(int &file) {
  if (file >= 0) close(file);
  file = -1;
}

} // namespace

bool Arms::open(int count, pid_t *shared_pids) {
  pids_ = shared_pids;
  count_ = count;
  rlimit files;
  auto const wanted = static_cast<rlim_t>(4 * count + files_of_program);
  if (getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur < wanted) {
    files.rlim_cur = std::min<rlim_t>(wanted, files.rlim_max);
    setrlimit(RLIMIT_NOFILE, &files);
  }
  std::fill(pids_, pids_ + count, 0);
  bool is_open = pipe2(reports_, O_CLOEXEC) == 0;
  for (Channel &one : opened()) {
    int ends[2] = {-1, -1};
    is_open = is_open && pipe2(ends, O_CLOEXEC) == 0;
    one = {ends[0], ends[1], is_open ? memfd_create("symreal", MFD_CLOEXEC) : -1};
    is_open = is_open && one.file >= 0;
  }
  return is_open;
}

void Arms::close_all() {
  for (Channel &one : opened())
    for (int *file : {&one.listen, &one.speak, &one.file}) close_one(*file);
  for (int &file : reports_) close_one(file);
}

void Arms::send(int arm, Command command, std::vector<char> const &bytes) const {
  command.size = bytes.size();
  int const file = channels_[static_cast<std::size_t>(arm)].speak;
  (void)(write_whole(file, &command, sizeof command) && write_whole(file, bytes.data(), bytes.size()));
}

std::optional<Arms::Report> Arms::receive(int milliseconds) const {
  pollfd wanted = {reports_[0], POLLIN, 0};
  Report report;
  if (poll(&wanted, 1, milliseconds) != 1 || !read_whole(reports_[0], &report, sizeof report)) return std::nullopt;
  return report;
}

std::optional<Arrival> Arms::arrival(int arm) const {
  int const file = channels_[static_cast<std::size_t>(arm)].file;
  struct stat status;
  if (fstat(file, &status) != 0 || lseek(file, 0, SEEK_SET) != 0) return std::nullopt;
  std::vector<char> bytes(static_cast<std::size_t>(status.st_size));
  if (bytes.empty() || !read_whole(file, bytes.data(), bytes.size())) return std::nullopt;
  MessageReader reader(bytes);
  return Arrival::read(reader);
}

void Arms::kill_all(int but) const {
  for (int arm = 0; arm < count_; ++arm)
    if (arm != but && pids_[arm] > 0) kill(pids_[arm], SIGKILL);
}

void Arms::become(int arm) {
  pids_[arm] = getpid();
  for (Channel &one : opened()) close_one(one.speak); // so that an arm ends with its coordinator
  close_one(reports_[0]);
}

void Arms::write_arrival(int arm, Arrival const &arrival) const {
  MessageWriter writer;
  arrival.write(writer);
  write_whole(channels_[static_cast<std::size_t>(arm)].file, writer.bytes().data(), writer.bytes().size());
}

Arms::Command Arms::listen(int arm, std::vector<char> &bytes) const {
  int const file = channels_[static_cast<std::size_t>(arm)].listen;
  Command command;
  if (!read_whole(file, &command, sizeof command)) _exit(0);
  bytes.resize(command.size);
  if (!read_whole(file, bytes.data(), bytes.size())) _exit(0);
  return command;
}

void Arms::report(Report report) const { write_whole(reports_[1], &report, sizeof report); }

void write_merge(Arms::Merge const &merge, MessageWriter &writer) {
  writer.put_all(merge.nodes);
  writer.put(merge.numbers.size());
  for (auto const &[address, node] : merge.numbers) writer.put(address), writer.put(node);
  write_guards(merge.guards, writer);
  writer.put_all(merge.notes);
  writer.put(merge.arm);
  writer.put(merge.is_hypothetical);
}

Arms::Merge read_merge(MessageReader &reader) {
  Arms::Merge merge;
  merge.nodes = reader.get_all<std::vector<Pool::Row>>();
  merge.numbers.resize(reader.get<std::size_t>());
  for (auto &[address, node] : merge.numbers) {
    address = reader.get<std::uint64_t *>();
    node = reader.get<NodeId>();
  }
  merge.guards = read_guards(reader);
  merge.notes = reader.get_all<std::vector<StateNote>>();
  merge.arm = reader.get<NodeId>();
  merge.is_hypothetical = reader.get<bool>();
  return merge;
}

} // namespace symreal::trace
