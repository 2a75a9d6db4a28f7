#include "rewrite/unit/kept_facts.h"

#include "engine/support/installation.h"
#include "rewrite/facts/bytes.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/source/source_map.h"
#include "rewrite/unit/collect_source.h"

#include <clang/Basic/Version.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/SHA256.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>

namespace symreal::rewrite {

// Cached facts of a source.
struct KeptSource {
  Lookups lookups;
  std::set<std::string> kernel_functions;
  std::string configured;
  std::map<std::string, std::string> texts; // ids of the files' texts in the facts
  std::string facts;
};

template <class Take> void visit(Take &take, KeptSource &object) {
  auto &[lookups, kernel_functions, configured, texts, facts] = object;
  take(lookups, kernel_functions, configured, texts, facts);
}

namespace {

// Environment variables that Clang 19's driver and preprocessor read, and that affect what is compiled.
constexpr char const *variables[] = {"CPATH",
                                     "C_INCLUDE_PATH",
                                     "CPLUS_INCLUDE_PATH",
                                     "OBJC_INCLUDE_PATH",
                                     "OBJCPLUS_INCLUDE_PATH",
                                     "COMPILER_PATH",
                                     "CCC_OVERRIDE_OPTIONS",
                                     "CLANG_CONFIG_FILE_SYSTEM_DIR",
                                     "CLANG_CONFIG_FILE_USER_DIR",
                                     "CLANG_NO_DEFAULT_CONFIG",
                                     "SDKROOT",
                                     "SOURCE_DATE_EPOCH"};

class Key {
public:
  void add(std::string const &text) {
    std::string const size = std::to_string(text.size()) + ":";
    hash_.update(size);
    hash_.update(text);
  }
  void add(std::vector<std::string> const &texts) {
    add(std::to_string(texts.size()));
    for (std::string const &text : texts) add(text);
  }
  std::string result() { return llvm::toHex(hash_.final(), /*LowerCase=*/true); }

private:
  llvm::SHA256 hash_;
};

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

// Identity of this tool, down to the bytes of its code: another text for another build of this program or of a library
// that it is loaded with, Clang's among them. The linker gives each an identity that follows from its contents.
std::string const &tool_identity() {
  static std::string const identity = [] {
    std::string all;
    dl_iterate_phdr(add_identity, &all);
    return all;
  }();
  return identity;
}

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool tells_time(Facts const &facts) {
  for (auto const &[path, file] : facts.files)
    for (char const *macro : {"__DATE__", "__TIME__", "__TIMESTAMP__"})
      if (file.text.find(macro) != file.text.npos) return true;
  return false;
}

std::optional<std::string> text_of(std::string const &path, Request const &request) {
  for (TextSource const &one : request.texts)
    if (one.path == path) return one.text;
  auto const buffer = llvm::MemoryBuffer::getFile(path);
  return buffer ? std::optional((*buffer)->getBuffer().str()) : std::nullopt;
}

} // namespace

std::string KeptFacts::key(Compilation const &source) const {
  Key key;
  key.add(tool_identity());
  key.add(clang::getClangFullVersion());
  key.add(runtime_include());
  key.add({source.source, source.directory});
  key.add(source.flags);
  key.add(source.defines);
  llvm::SmallString<256> here;
  if (!llvm::sys::fs::current_path(here)) key.add(here.str().str());
  for (char const *name : variables) {
    char const *const value = std::getenv(name);
    key.add(value ? std::string("=") + value : "");
  }
  key.add(scope_.roots);
  key.add(scope_.exclude.directory);
  key.add(scope_.exclude.patterns);
  key.add(request_.type_name);
  for (ConfiguredExternal const &external : request_.externals) key.add(to_bytes(external));
  for (TextSource const &one : request_.texts) key.add({one.path, one.text});
  return key.result();
}

std::string KeptFacts::configured(std::set<std::string> const &functions) const {
  std::string all;
  for (std::size_t i = 0; i < request_.kernels.size(); ++i)
    if (functions.contains(configured_name(request_.kernels[i])))
      all += std::to_string(i) + ":" + to_bytes(request_.kernels[i]);
  return all;
}

std::optional<Facts> KeptFacts::find(std::string const &key) {
  std::optional<std::string> const bytes = request_.kept->find(key);
  if (!bytes) return {};
  Read read(*bytes);
  KeptSource kept;
  read(kept);
  if (!read.is_complete() || configured(kept.kernel_functions) != kept.configured || !disk_.still_answers(kept.lookups))
    return {};
  std::optional<Facts> facts = facts_of_bytes(kept.facts);
  if (!facts) return {};
  for (auto &[path, file] : facts->files) {
    std::optional<std::string> text = text_of(path, request_);
    if (!text || content_id(*text) != kept.texts[path]) return {};
    file.text = std::move(*text);
  }
  return facts;
}

void KeptFacts::keep(std::string const &key, Lookups const &lookups, Facts const &facts) {
  Facts bare = facts;
  KeptSource kept{lookups, facts.kernel_functions, configured(facts.kernel_functions), {}, {}};
  for (auto &[path, file] : bare.files) {
    kept.texts[path] = content_id(file.text);
    file.text.clear();
  }
  kept.facts = to_bytes(std::move(bare));
  Write write;
  write(kept);
  request_.kept->keep(key, write.result());
}

Facts KeptFacts::collect(Compilation const &source) {
  std::string const key = request_.kept ? this->key(source) : "";
  if (request_.kept)
    if (std::optional<Facts> facts = find(key)) {
      ++found_;
      return std::move(*facts);
    }
  ++read_;
  Lookups lookups;
  double const begin = processor_seconds();
  Facts facts = collect_source(source, scope_, request_, watched_disk(lookups));
  {
    std::scoped_lock const lock(mutex_);
    seconds_[real_source(source)] = processor_seconds() - begin;
  }
  if (request_.kept && !facts.broken && !tells_time(facts)) keep(key, lookups, facts);
  return facts;
}

} // namespace symreal::rewrite
