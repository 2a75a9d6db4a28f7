#include "runtime/trace/decisions/arms.h"

#include "engine/support/files.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/trace/report/events.h"

#include <symreal/text.h>

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

// Defined here because text/ depends on this folder.
__thread bool symreal::detail::has_text = false;

namespace symreal::trace {
namespace {

unsigned modes_of_arithmetic() {
  unsigned modes = static_cast<unsigned>(std::fegetround());
#ifdef __SSE__
  constexpr unsigned flags = 0x3f;
  modes |= (_mm_getcsr() & ~flags) << 16;
#endif
  return modes;
}

void write_guards(std::vector<Guards::Recorded> const &guards, MessageWriter &writer) {
  writer.put(guards.size());
  for (Guards::Recorded const &guard : guards) {
    writer.put(guard.needed);
    writer.put_all(std::vector(guard.arms.begin(), guard.arms.end()));
    writer.put_all(guard.text);
    writer.put(guard.reason);
    writer.put_all(guard.stack);
  }
}

std::vector<Guards::Recorded> read_guards(MessageReader &reader) {
  std::vector<Guards::Recorded> guards(reader.get<std::size_t>());
  for (Guards::Recorded &guard : guards) {
    guard.needed = reader.get<NodeId>();
    auto const arms = reader.get_all<std::vector<NodeId>>();
    guard.arms = {arms.begin(), arms.end()};
    guard.text = reader.get_all<std::string>();
    guard.reason = reader.get<Guards::Reason>();
    guard.stack = reader.get_all<std::vector<std::uintptr_t>>();
  }
  return guards;
}

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

PartingPoint PartingPoint::now() {
  return {static_cast<NodeId>(session().pool.nodes().size()), session().guards.recorded().size(), trace::told(),
          session().externals.last_effect(), detail::has_text};
}

std::optional<Arrival> Arrival::here(PartingPoint const &since, Stand *stand, bool is_hypothetical) {
  std::optional<Arrival> arrival = Arrival::since(since, is_hypothetical);
  if (!arrival) return arrival;
  arrival->image = ProcessImage::capture(stand);
  arrival->stack = call_stack();
  return arrival;
}

std::optional<Arrival> Arrival::at_end(PartingPoint const &since, std::vector<RealNumber> const &results,
                                       std::size_t interface, bool is_hypothetical) {
  std::optional<Arrival> arrival = Arrival::since(since, is_hypothetical);
  if (!arrival) return arrival;
  arrival->facts.interface = interface;
  arrival->image = ProcessImage::of_results(results);
  return arrival;
}

std::optional<Arrival> Arrival::since(PartingPoint const &parted, bool is_hypothetical) {
  bool const has_effect = session().externals.last_effect().to_bits() != parted.last_effect.to_bits();
  bool const has_text = detail::has_text != parted.has_text;
  if (has_effect || has_text || told() != parted.told || !session().state.is_journal_complete()) return std::nullopt;
  Arrival arrival;
  arrival.facts = {session().externals.tables().size(), session().externals.functions().size(),
                   static_cast<int>(decisions()), modes_of_arithmetic()};
  arrival.nodes = session().pool.rows_from(parted.nodes);
  std::vector<Guards::Recorded> const &guards = session().guards.recorded();
  arrival.guards.assign(guards.begin() + static_cast<std::ptrdiff_t>(parted.guards), guards.end());
  arrival.notes = session().state.journal();
  arrival.arm = session().conditions.arm;
  arrival.is_hypothetical = is_hypothetical;
  return arrival;
}

void Arrival::write(MessageWriter &writer) const {
  writer.put(facts);
  image.write(writer);
  writer.put_all(nodes);
  write_guards(guards, writer);
  writer.put_all(notes);
  writer.put_all(stack);
  writer.put(arm);
  writer.put(is_hypothetical);
}

Arrival Arrival::read(MessageReader &reader) {
  Arrival arrival;
  arrival.facts = reader.get<Facts>();
  arrival.image = ProcessImage::read(reader);
  arrival.nodes = reader.get_all<std::vector<Pool::Row>>();
  arrival.guards = read_guards(reader);
  arrival.notes = reader.get_all<std::vector<StateNote>>();
  arrival.stack = reader.get_all<std::vector<std::uintptr_t>>();
  arrival.arm = reader.get<RealNumber>();
  arrival.is_hypothetical = reader.get<bool>();
  return arrival;
}

bool Arms::open(int count, pid_t *shared_pids) {
  pids_ = shared_pids;
  channels_.assign(static_cast<std::size_t>(count), {});
  rlimit files;
  auto const wanted = static_cast<rlim_t>(4 * count + files_of_program);
  if (getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur < wanted) {
    files.rlim_cur = std::min<rlim_t>(wanted, files.rlim_max);
    setrlimit(RLIMIT_NOFILE, &files);
  }
  std::fill(pids_, pids_ + count, 0);
  bool is_open = pipe2(reports_, O_CLOEXEC) == 0;
  for (Channel &one : channels_) {
    int ends[2] = {-1, -1};
    is_open = is_open && pipe2(ends, O_CLOEXEC) == 0;
    one = {ends[0], ends[1], is_open ? memfd_create("symreal", MFD_CLOEXEC) : -1};
    is_open = is_open && one.file >= 0;
  }
  return is_open;
}

void Arms::close_all() {
  for (Channel &one : channels_)
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
  for (int arm = 0; arm < count(); ++arm)
    if (arm != but && pids_[arm] > 0) kill(pids_[arm], SIGKILL);
}

void Arms::become(int arm) {
  pids_[arm] = getpid();
  for (Channel &one : channels_) close_one(one.speak); // so that an arm ends with its coordinator
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
