#include "runtime/wire/request.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace symreal::wire {
namespace {

constexpr std::array entry_names = {
#define REQUEST(name, meaning) #name,
#include "runtime/wire/request.def"
#undef REQUEST
};

constexpr std::string_view head = "symreal-request 1\n";
constexpr std::size_t most_text = 1 << 20;

// Not on the heap, which the program may count, and not in pages that a program without a request touches.
struct Text {
  bool is_read = false;
  std::size_t size = 0;
  char bytes[most_text + 1];
};
Text text;

// A descriptor with another file is one that the program has reused for a process of its own.
void read_descriptor(int descriptor) {
  std::size_t size = 0;
  while (size < most_text) {
    ssize_t const got = pread(descriptor, text.bytes + size, most_text - size, static_cast<off_t>(size));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size == most_text) {
    std::fputs("symreal: the request is too long\n", stderr);
    _exit(127);
  }
  if (std::string_view(text.bytes, size).starts_with(head)) text.size = size;
}

void read_entries(std::string_view entries) {
  if (entries.size() >= most_text) return;
  std::memcpy(text.bytes, entries.data(), entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (text.bytes[k] == ';') text.bytes[k] = 0;
  text.size = entries.size() + 1; // the last one ends in a zero byte as well
}

[[gnu::constructor(101)]] void read_request() {
  if (text.is_read) return;
  text.is_read = true;
  char const *const given = std::getenv(request_variable);
  if (!given) return;
  char *end = nullptr;
  long const descriptor = std::strtol(given, &end, 10);
  if (end != given && *end == 0)
    read_descriptor(static_cast<int>(descriptor));
  else
    read_entries(given);
}

char const *find(std::string_view name) {
  read_request(); // another constructor may be earlier
  std::string_view rest(text.bytes, text.size);
  if (rest.starts_with(head)) rest.remove_prefix(head.size());
  while (!rest.empty()) {
    std::string_view const entry = rest.substr(0, rest.find('\0'));
    if (entry.size() > name.size() && entry.starts_with(name) && entry[name.size()] == '=')
      return entry.data() + name.size() + 1;
    rest.remove_prefix(std::min(entry.size() + 1, rest.size()));
  }
  return nullptr;
}

} // namespace

char const *requested(Entry entry) { return find(entry_names[static_cast<std::size_t>(entry)]); }

void Request::set(Entry entry, std::string_view value) {
  text_.append(entry_names[static_cast<std::size_t>(entry)]).append("=").append(value) += '\0';
}

std::string Request::content() const { return std::string(head) + text_; }

// For the texts that the tool adds to sources, C among them.
extern "C" char const *symreal_requested(char const *name) { return find(name); }

} // namespace symreal::wire
