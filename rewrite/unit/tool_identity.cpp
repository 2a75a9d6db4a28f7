#include "rewrite/unit/tool_identity.h"

#include <cstring>
#include <fmt/format.h>
#include <link.h>
#include <string_view>
#include <sys/stat.h>

namespace symreal::rewrite {
namespace {

// The note of the linker, else nothing.
std::string_view build_id(dl_phdr_info const &object) {
  for (ElfW(Half) i = 0; i < object.dlpi_phnum; ++i) {
    ElfW(Phdr) const &segment = object.dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    auto const aligned = [&](std::size_t size) {
      return (size + segment.p_align - 1) / segment.p_align * segment.p_align;
    };
    if (segment.p_align != 4 && segment.p_align != 8) continue;
    char const *const notes = reinterpret_cast<char const *>(object.dlpi_addr + segment.p_vaddr);
    for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= segment.p_memsz;) {
      ElfW(Nhdr) note;
      std::memcpy(&note, notes + at, sizeof note);
      std::size_t const name = at + sizeof note, contents = aligned(name + note.n_namesz);
      if (note.n_type == NT_GNU_BUILD_ID && std::string_view(notes + name, note.n_namesz) == std::string_view("GNU", 4))
        return {notes + contents, note.n_descsz};
      at = aligned(contents + note.n_descsz);
    }
  }
  return {};
}

// An object without the note goes by its path, size and time.
std::string file_identity(char const *name) {
  std::string const path = *name ? name : "/proc/self/exe";
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return path; // the kernel's own
  return fmt::format("{} {} {}.{}", path, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
}

int add_identity(dl_phdr_info *object, std::size_t, void *all) {
  std::string_view const id = build_id(*object);
  auto &text = *static_cast<std::string *>(all);
  for (char const byte : id) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  text += id.empty() ? file_identity(object->dlpi_name) + "\n" : "\n";
  return 0;
}

} // namespace

std::string const &tool_identity() {
  static std::string const identity = [] {
    std::string all;
    dl_iterate_phdr(add_identity, &all);
    return all;
  }();
  return identity;
}

} // namespace symreal::rewrite
