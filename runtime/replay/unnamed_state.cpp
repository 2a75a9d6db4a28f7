#include "runtime/replay/unnamed_state.h"

#include "runtime/memory/access_watch.h"
#include "runtime/replay/replay_server.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <fstream>
#include <set>
#include <sys/mman.h>

namespace symreal::replay {
namespace {

using memory::Change;
using memory::Known;
using memory::KnownBytes;
using memory::MemoryImage;
using memory::Region;

// Bytes that the kernel meets, by the first of them.
struct Candidate {
  char *address;
  std::uintptr_t instruction;
  unsigned char room; // how many bytes from there on no clause names
  bool is_read, is_written;
};

// Memory that the forks share with this process, to report. One fork runs at a time.
struct Told {
  std::uint32_t count;
  bool are_all;                 // else there are more
  Candidate const *overwritten; // one of those that were changed
  Candidate all[1 << 13];
};
Told *told = nullptr;

bool is_watching = false; // until all inputs are given
enum class Role { none, watches, tries };
Role role = Role::none;                         // of this process
constinit std::vector<Candidate const *> tried; // the bytes that were changed

struct Addresses {
  std::set<char const *> changeable,
      leading;                      // static variables; those of the second kind only lead to changeable memory
  std::set<char const *> looked_up; // read to look up inputs, parameters and constants
};
// Made at the first use: a kernel may run before the constructors of static objects.
Addresses &addresses() {
  static Addresses all;
  return all;
}

constexpr unsigned seconds = 2, seconds_watched = 10; // for a run
constexpr std::size_t most_objects = 64;
constexpr std::chrono::seconds most_time{4};

// A change of bytes of unknown type and size: a small integer, a truth value or a letter becomes another one; a number
// of single or double precision another, larger, or negative one.
struct Trial {
  unsigned char offset, flips;
};
constexpr std::array trials = {Trial{0, 0x01}, Trial{6, 0x08}, Trial{2, 0x40}, Trial{7, 0x80},
                               Trial{3, 0x80}, Trial{0, 0x40}, Trial{0, 0x02}, Trial{1, 0x01}};

constexpr Trial for_writes{0, 0x04}; // a count of owners stays one

bool is_changeable(Change const &object) {
  return object.region != Region::static_object || addresses().changeable.contains(object.object);
}

// Whether the access belongs to a lock, which is unchanged after its release.
bool is_of_locks(memory::Access const &access) {
  Dl_info code;
  if (dladdr(memory::code_at(access), &code) == 0 || !code.dli_sname) return false;
  std::string_view const name = code.dli_sname;
  return name.starts_with("pthread_") || name.starts_with("__pthread_");
}

// All memory that the program can point to.
class Mappings {
public:
  Mappings() {
    std::FILE *file = std::fopen("/proc/self/maps", "r");
    if (!file) return;
    char line[512];
    std::uintptr_t begin = 0, end = 0;
    while (std::fgets(line, sizeof line, file))
      if (std::sscanf(line, "%zx-%zx", &begin, &end) == 2) all_.emplace_back(begin, end);
    std::fclose(file);
  }
  bool is_pointer(char const *address) const {
    std::uintptr_t word = 0;
    std::memcpy(&word, address - reinterpret_cast<std::uintptr_t>(address) % sizeof word, sizeof word);
    return std::ranges::any_of(all_, [word](auto const &one) { return one.first <= word && word < one.second; });
  }

private:
  std::vector<std::pair<std::uintptr_t, std::uintptr_t>> all_;
};

void keep_candidates(MemoryImage const &image, Named const &named, memory::Accesses const &accesses) {
  KnownBytes const read(named.read), written(named.written);
  std::vector<memory::HeapBlock> const blocks = memory::heap_blocks();
  Mappings const mappings;
  told->are_all = accesses.are_complete;
  for (memory::Access const &one : accesses.all) {
    std::optional<Change> const object = image.object_at(one.address);
    if (!object || !is_changeable(*object) || is_of_locks(one)) continue;
    auto const left = static_cast<std::size_t>(object->object + object->size - one.address);
    std::size_t const to_word = 8 - reinterpret_cast<std::uintptr_t>(one.address) % 8;
    std::size_t const room = read.room(one.address, std::min(left, to_word));
    bool const is_named = one.is_named || addresses().looked_up.contains(one.address);
    bool const is_read = one.is_read_first && !is_named && room != 0 && !mappings.is_pointer(one.address);
    bool const is_written = one.is_written && !written.has(one.address) && image.outlives(blocks, one.address);
    Candidate const candidate = {one.address, one.instruction,
                                 static_cast<unsigned char>(std::max<std::size_t>(room, 1)), is_read, is_written};
    if (!candidate.is_read && !candidate.is_written) continue;
    if (told->count == std::size(told->all)) return void(told->are_all = false);
    told->all[told->count++] = candidate;
  }
}

bool same_bits(std::vector<double> const &a, std::vector<double> const &b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool watch_changeable(MemoryImage const &image) {
  std::vector<memory::WatchedBytes> bytes;
  for (Change const &one : image.objects())
    if (is_changeable(one)) bytes.push_back({one.object, one.size});
  return memory::begin_watching_accesses(bytes);
}

// Examination, in the process that runs the forks.
class Examination {
public:
  explicit Examination(MemoryImage const &image) : image_(image) {}

  // False in a fork, which runs the kernel on.
  bool run() {
    Ran ran = replay_in_fork(seconds);
    if (ran == Ran::here) return false;
    if (ran == Ran::badly) return replay_unexamined("the original did not end when it was run on"), true;
    outputs_ = replay_outputs();
    ran = replay_in_fork(seconds_watched);
    if (ran == Ran::here) {
      if (watch_changeable(image_)) role = Role::watches;
      return false;
    }
    if (ran == Ran::badly) return replay_unexamined("the original did not end while it was watched"), true;
    if (!same_bits(outputs_, replay_outputs())) return replay_unexamined("the original gave other outputs again"), true;
    std::vector<Object> const objects = objects_met();
    std::size_t count = 0;
    for (Object const &object : objects) {
      if (count == most_objects || is_over()) break;
      ++count;
      if (!try_reads(object) || !try_writes(object)) return false;
    }
    if (count < objects.size())
      replay_unexamined(std::to_string(objects.size() - count) + " objects that it meets were not tried");
    else if (!told->are_all)
      replay_unexamined("it was watched in part, as it meets memory very often");
    return true;
  }

private:
  struct Object {
    Change where;
    std::vector<Candidate const *> candidates;
  };

  bool is_over() const { return std::chrono::steady_clock::now() - begun_ > most_time; }

  std::vector<Object> objects_met() const {
    std::vector<Object> objects;
    for (std::uint32_t k = 0; k < told->count; ++k) {
      std::optional<Change> const object = image_.object_at(told->all[k].address);
      if (!object) continue;
      if (objects.empty() || objects.back().where.object != object->object) objects.push_back({*object, {}});
      objects.back().candidates.push_back(&told->all[k]);
    }
    return objects;
  }

  Ran try_one(std::vector<Candidate const *> const &candidates, Trial trial) {
    Ran const ran = replay_in_fork(seconds);
    if (ran != Ran::here) return ran;
    for (Candidate const *one : candidates)
      if (trial.offset < one->room)
        one->address[trial.offset] = static_cast<char>(one->address[trial.offset] ^ trial.flips);
    role = Role::tries;
    tried = candidates;
    return ran;
  }

  void tell(Change object, Candidate const &candidate, bool is_read) {
    object.first = static_cast<std::size_t>(candidate.address - object.object);
    object.end = object.first + 1;
    replay_unnamed({left_behind(object), candidate.instruction, is_read, 0});
  }

  bool try_reads(Object const &object) {
    std::vector<Candidate const *> all = object.candidates;
    std::erase_if(all, [](Candidate const *one) { return !one->is_read; });
    for (Trial const &trial : trials) {
      if (std::ranges::none_of(all, [&](Candidate const *one) { return trial.offset < one->room; })) continue;
      Ran ran = try_one(all, trial);
      if (ran == Ran::here) return false;
      if (ran == Ran::badly || same_bits(outputs_, replay_outputs())) continue;
      // Tries each alone to find the one.
      for (std::size_t k = 0; all.size() > 1 && k < all.size() && !is_over(); ++k) {
        ran = try_one({all[k]}, trial);
        if (ran == Ran::here) return false;
        if (ran == Ran::badly || same_bits(outputs_, replay_outputs())) continue;
        return tell(object.where, *all[k], true), true;
      }
      return tell(object.where, *all[0], true), true;
    }
    return true;
  }

  // Tries all at once, and each alone if the original does not end so.
  bool try_writes(Object const &object) {
    std::vector<Candidate const *> all = object.candidates;
    std::erase_if(all, [](Candidate const *one) { return !one->is_written; });
    if (all.empty()) return true;
    told->overwritten = nullptr;
    Ran ran = try_one(all, for_writes);
    for (std::size_t k = 0; ran == Ran::badly && k < all.size() && !is_over(); ++k) ran = try_one({all[k]}, for_writes);
    if (ran == Ran::here) return false;
    if (ran == Ran::well && told->overwritten) tell(object.where, *told->overwritten, false);
    return true;
  }

  MemoryImage const &image_;
  std::vector<double> outputs_;
  std::chrono::steady_clock::time_point const begun_ = std::chrono::steady_clock::now();
};

} // namespace

void begin_examination(MemoryImage const &image, std::string const &names) {
  memory::OwnWork const own;
  std::vector<Change> const objects = image.objects();
  std::ifstream file(names);
  for (std::string line; std::getline(file, line);) {
    bool const is_leading = line.starts_with('*');
    std::string const name = memory::without_tags(line.substr(is_leading ? 1 : 0));
    for (Change const &one : objects)
      if (one.region == Region::static_object && memory::name_in_c(one.name) == name)
        (is_leading ? addresses().leading : addresses().changeable).insert(one.object);
  }
  is_watching = watch_changeable(image);
}

void look_up_items(bool are_looked_up) { memory::watch_names(are_looked_up); }

std::vector<Known> fixed_owners(MemoryImage const &image) {
  std::vector<Known> fixed;
  for (Change const &one : image.objects())
    if (!is_changeable(one) && !addresses().leading.contains(one.object)) fixed.push_back({one.object, one.size});
  return fixed;
}

void examine_state(MemoryImage const &image) {
  memory::Accesses const accesses = is_watching ? memory::end_watching_accesses() : memory::Accesses{};
  memory::OwnWork const own;
  for (memory::Access const &one : accesses.all)
    if (one.is_read_first) addresses().looked_up.insert(one.address);
  void *memory = mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  told = memory == MAP_FAILED ? nullptr : static_cast<Told *>(memory);
  if (!is_watching || !told) replay_unexamined("accesses to memory cannot be watched here");
  if (!is_watching || !told || Examination(image).run()) replay_examined();
}

void end_examined(MemoryImage const &image, std::function<Named()> const &named) {
  memory::OwnWork const own;
  if (role == Role::watches) {
    memory::Accesses const accesses = memory::end_watching_accesses();
    keep_candidates(image, named(), accesses);
  }
  if (role != Role::tries) return;
  std::vector<memory::HeapBlock> const blocks = memory::heap_blocks();
  for (Candidate const *one : tried)
    if (char const *before = image.before(one->address); before && image.outlives(blocks, one->address) &&
                                                         *one->address != static_cast<char>(*before ^ for_writes.flips))
      told->overwritten = one;
}

} // namespace symreal::replay
