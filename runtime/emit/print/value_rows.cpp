#include "emit/print/value_rows.h"

#include <bit>
#include <map>
#include <numeric>

namespace symreal {

void write_once(ValueRows &rows) {
  std::size_t const count = rows.columns.front()->size();
  std::map<std::vector<std::uint64_t>, std::uint32_t> known;
  std::vector<std::uint32_t> written, which;
  for (std::uint32_t row = 0; row < count; ++row) {
    std::vector<std::uint64_t> key;
    for (auto const *column : rows.columns) key.push_back(std::bit_cast<std::uint64_t>((*column)[row]));
    auto const [entry, is_new] = known.try_emplace(std::move(key), static_cast<std::uint32_t>(written.size()));
    if (is_new) written.push_back(row);
    which.push_back(entry->second);
  }
  if (2 * written.size() <= count) {
    rows.written = std::move(written);
    rows.which = std::move(which);
  } else {
    rows.written.resize(count);
    std::iota(rows.written.begin(), rows.written.end(), 0U);
  }
}

} // namespace symreal
