// Uses for which expressions of the sources are wrapped: the table in uses.def.
#pragma once

#include <optional>
#include <string_view>

namespace symreal::rewrite {

enum class Use {
#define USE(name, payload, traits, text, what) name,
#include "rewrite/facts/uses.def"
#undef USE
};

enum class Payload { none, type, arguments, place, bits, function, text, parameters, name, words, layout };

namespace trait {
enum OfUse : unsigned { NEEDED = 1, BY_TYPES = 2, BRACE = 4, OUTERMOST = 8 };
}

struct UseInfo {
  std::string_view name;
  Payload payload;
  unsigned traits;
  std::string_view text;
  bool has(unsigned wanted) const { return (traits & wanted) != 0; }
};

UseInfo const &info(Use use);
std::optional<Use> find_use(std::string_view name);

} // namespace symreal::rewrite
