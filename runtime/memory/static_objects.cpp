#include "runtime/memory/static_objects.h"

#include "runtime/memory/heap_blocks.h"
#include "runtime/memory/own_memory.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <elf.h>
#include <fcntl.h>
#include <link.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace symreal::memory {
namespace {

// A file mapped for the scope's duration.
class MappedFile {
public:
  explicit MappedFile(char const *path) {
    int const descriptor = open(path, O_RDONLY | O_CLOEXEC);
    struct stat status;
    if (descriptor >= 0 && fstat(descriptor, &status) == 0 && status.st_size > 0) {
      size_ = static_cast<std::size_t>(status.st_size);
      void *memory = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, descriptor, 0);
      if (memory != MAP_FAILED) begin_ = static_cast<char const *>(memory);
    }
    if (descriptor >= 0) close(descriptor);
  }
  ~MappedFile() {
    if (begin_) munmap(const_cast<char *>(begin_), size_);
  }
  MappedFile(MappedFile const &) = delete;
  MappedFile &operator=(MappedFile const &) = delete;

  template <class T> T const *at(std::size_t offset, std::size_t count = 1) const {
    bool const fits = begin_ && offset <= size_ && count <= (size_ - offset) / sizeof(T);
    return fits ? reinterpret_cast<T const *>(begin_ + offset) : nullptr;
  }

private:
  char const *begin_ = nullptr;
  std::size_t size_ = 0;
};

// One loaded file: its address range, its parts that are constant after relocation, and its variables of this thread.
struct Loaded {
  std::uintptr_t base;
  std::string path;
  std::uintptr_t constant_begin = 0, constant_end = 0;
  char *thread_begin = nullptr;
};

// Whether the mangled name lies in namespace std, __gnu_cxx or symreal, behind a prefix for its kind.
bool is_of_library(std::string_view name) {
  if (name.find('@') != name.npos) return true; // copied from a shared library
  if (name.starts_with("symreal_")) return true;
  if (!name.starts_with("_Z")) return name.starts_with("__") || name.starts_with("_IO_") || name == "completed.0";
  name.remove_prefix(2);
  for (std::string_view kind : {"TV", "TI", "TS", "TT", "TC"})
    if (name.starts_with(kind)) return true;
  for (std::string_view prefix : {"GV", "GR", "TH", "TW", "Z", "N", "K", "L"})
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  for (std::string_view prefix : {"Z", "N", "K", "L"})
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  static constexpr std::array libraries = {"St", "Sa", "Ss", "9__gnu_cxx", "10__cxxabiv1", "7symreal", "3fmt"};
  return std::any_of(libraries.begin(), libraries.end(), [name](char const *one) { return name.starts_with(one); });
}

enum class Changes { variables, constants };

char *thread_pointer() { return static_cast<char *>(__builtin_thread_pointer()); }

void add_objects(Loaded const &loaded, Changes changes, std::vector<StaticObject> &objects) {
  MappedFile const file(loaded.path.c_str());
  auto const *head = file.at<ElfW(Ehdr)>(0);
  if (!head || std::memcmp(head->e_ident, ELFMAG, SELFMAG) != 0) return;
  auto const *sections = file.at<ElfW(Shdr)>(head->e_shoff, head->e_shnum);
  if (!sections) return;
  for (unsigned s = 0; s < head->e_shnum; ++s) {
    if (sections[s].sh_type != SHT_SYMTAB || sections[s].sh_link >= head->e_shnum) continue;
    std::size_t const count = sections[s].sh_size / sizeof(ElfW(Sym));
    auto const *symbols = file.at<ElfW(Sym)>(sections[s].sh_offset, count);
    ElfW(Shdr) const &names = sections[sections[s].sh_link];
    auto const *text = file.at<char>(names.sh_offset, names.sh_size);
    if (!symbols || !text) return;
    for (std::size_t k = 0; k < count; ++k) {
      ElfW(Sym) const &symbol = symbols[k];
      unsigned const type = symbol.st_info & 0xf;
      if ((type != STT_OBJECT && type != STT_TLS) || symbol.st_size == 0 || symbol.st_name >= names.sh_size) continue;
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx >= head->e_shnum) continue;
      bool const is_variable = (sections[symbol.st_shndx].sh_flags & SHF_WRITE) != 0;
      if (changes == Changes::variables && (!is_variable || is_of_library(text + symbol.st_name))) continue;
      if (type == STT_TLS && !loaded.thread_begin) continue;
      char *begin = type == STT_TLS ? loaded.thread_begin + symbol.st_value
                                    : reinterpret_cast<char *>(loaded.base + symbol.st_value);
      auto const at = reinterpret_cast<std::uintptr_t>(begin);
      bool const is_constant = !is_variable || (loaded.constant_begin <= at && at < loaded.constant_end);
      if (type == STT_OBJECT && is_constant != (changes == Changes::constants)) continue;
      objects.push_back({without_tags(text + symbol.st_name), begin, symbol.st_size, symbol.st_info >> 4 == STB_LOCAL});
    }
  }
}

bool is_of_system(std::string_view path) {
  return path.starts_with("/lib") || path.starts_with("/usr/lib") || path.starts_with("linux-vdso");
}

std::vector<StaticObject> find_objects(Changes changes) {
  std::vector<Loaded> all;
  dl_iterate_phdr(
      [](dl_phdr_info *object, std::size_t, void *list) {
        auto &loaded = *static_cast<std::vector<Loaded> *>(list);
        bool const is_executable = loaded.empty(); // it comes first
        Loaded one{object->dlpi_addr, is_executable ? "/proc/self/exe" : object->dlpi_name};
        for (int i = 0; i < object->dlpi_phnum; ++i) {
          auto const &part = object->dlpi_phdr[i];
          if (part.p_type == PT_GNU_RELRO) {
            one.constant_begin = object->dlpi_addr + part.p_vaddr;
            one.constant_end = one.constant_begin + part.p_memsz;
          }
#ifdef __x86_64__
          // The executable's variables of a thread lie right below its thread pointer.
          if (part.p_type == PT_TLS && is_executable && part.p_align > 0)
            one.thread_begin = thread_pointer() - (part.p_memsz + part.p_align - 1) / part.p_align * part.p_align;
#endif
        }
        loaded.push_back(one);
        return 0;
      },
      &all);
  std::vector<StaticObject> objects;
  for (Loaded const &one : all)
    if (!is_of_system(one.path)) add_objects(one, changes, objects);
  auto const before = [](StaticObject const &a, StaticObject const &b) { return a.begin < b.begin; };
  std::sort(objects.begin(), objects.end(), before);
  // One object may have several names.
  auto const same = [](StaticObject const &a, StaticObject const &b) { return a.begin == b.begin; };
  objects.erase(std::unique(objects.begin(), objects.end(), same), objects.end());
  return objects;
}

char const *end_of_stack(char const *address) {
  Stack const stack = Stack::of_this_thread();
  return stack.begin <= address && address < stack.end ? stack.end : nullptr;
}

} // namespace

std::vector<StaticObject> find_static_objects() { return find_objects(Changes::variables); }

std::vector<StaticObject> find_constants() { return find_objects(Changes::constants); }

std::string without_tags(std::string name) {
  constexpr std::string_view tag = "B5cxx11";
  for (std::size_t at = name.find(tag); at != name.npos; at = name.find(tag)) name.erase(at, tag.size());
  return name;
}

std::string name_in_c(std::string const &linker_name) {
  std::size_t const dot = linker_name.starts_with("_Z") ? linker_name.npos : linker_name.find('.');
  if (dot == linker_name.npos) return linker_name;
  bool const is_number = linker_name.find_first_not_of("0123456789", dot + 1) == linker_name.npos;
  return is_number ? linker_name.substr(0, dot) : linker_name.substr(dot + 1);
}

std::string guarded_by(std::string const &name) { return name.starts_with("_ZGV") ? "_Z" + name.substr(4) : ""; }

// _ZGR <name of the reference> [<sequence number>] _
bool is_kept_alive_by(std::string_view temporary, std::string_view reference) {
  if (!temporary.starts_with("_ZGR") || !reference.starts_with("_Z")) return false;
  temporary.remove_prefix(4);
  reference.remove_prefix(2);
  if (!temporary.starts_with(reference) || !temporary.ends_with('_')) return false;
  std::string_view const number = temporary.substr(reference.size(), temporary.size() - reference.size() - 1);
  return number.find_first_not_of("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ") == number.npos;
}

char const *object_end(void const *address) {
  char const *const at = static_cast<char const *>(address);
  static std::vector<StaticObject> const statics = find_static_objects();
  if (char const *end = end_of_stack(at)) return end;
  std::vector<HeapBlock> const blocks = heap_blocks();
  if (HeapBlock const *block = object_around(blocks, at)) return block->begin + block->size;
  if (StaticObject const *object = object_around(statics, at)) return object->begin + object->size;
  return at + 1;
}

Constant constant_around(void const *address) {
  char const *const at = static_cast<char const *>(address);
  static std::vector<StaticObject> const constants = find_constants();
  auto const behind = std::upper_bound(constants.begin(), constants.end(), at,
                                       [](char const *wanted, StaticObject const &one) { return wanted < one.begin; });
  char const *const next = behind == constants.end() ? reinterpret_cast<char const *>(UINTPTR_MAX) : behind->begin;
  if (behind == constants.begin()) return {nullptr, next};
  StaticObject const &before = *(behind - 1);
  char const *const end = before.begin + before.size;
  return at < end ? Constant{before.begin, end} : Constant{end, next};
}

} // namespace symreal::memory
