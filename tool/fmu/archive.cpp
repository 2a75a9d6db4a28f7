#include "tool/fmu/archive.h"

#include "engine/diagnostics/diagnostic.h"

#include <zip.h>

namespace symreal::tool {

// Works in memory, so only allocation can fail.
std::string archive(std::vector<std::pair<std::string, std::string>> const &files) {
  constexpr zip_uint16_t first_day = (1U << 5U) | 1U; // of 1980, the format's epoch
  zip_source_t *const buffer = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  internal_check(buffer != nullptr);
  zip_source_keep(buffer);
  zip_t *const zip = zip_open_from_source(buffer, ZIP_TRUNCATE, nullptr);
  internal_check(zip != nullptr);
  for (auto const &[name, text] : files) {
    zip_source_t *const source = zip_source_buffer(zip, text.data(), text.size(), 0);
    zip_int64_t const index = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    internal_check(index >= 0);
    internal_check(zip_file_set_dostime(zip, static_cast<zip_uint64_t>(index), 0, first_day, 0) == 0);
  }
  internal_check(zip_close(zip) == 0);
  zip_stat_t about;
  internal_check(zip_source_open(buffer) == 0 && zip_source_stat(buffer, &about) == 0);
  std::string bytes(about.size, '\0');
  internal_check(zip_source_read(buffer, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(buffer);
  zip_source_free(buffer);
  return bytes;
}

} // namespace symreal::tool
