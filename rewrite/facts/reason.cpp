#include "rewrite/facts/reason.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace symreal::rewrite {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(ReasonId::call_with) + 1> table = {
#define REASON(name, words) words,
#include "rewrite/facts/reasons.def"
#undef REASON
};

std::string filled(Reason const &reason, std::string const &subject) {
  std::string text(table[static_cast<std::size_t>(reason.id)]);
  if (std::size_t const at = text.find('$'); at != text.npos) text.replace(at, 1, subject);
  return text;
}

} // namespace

std::string words(Reason const &reason) {
  std::string text = filled(reason, reason.subject);
  for (Reason const &one : reason.because) {
    text += " " + words(one);
    if (!reason.place.file.empty()) text += " (" + to_string(reason.place) + ")";
  }
  return text;
}

std::string kind(Reason const &reason) {
  std::string text = filled(reason, "'...'");
  if (reason.because.empty()) return text;
  Reason const *next = &reason.because.front();
  if (reason.id == ReasonId::call_with)
    while (next->id == ReasonId::call_with) next = &next->because.front();
  return text + " " + kind(*next);
}

} // namespace symreal::rewrite
