#include "rewrite/text/compose.h"

#include "rewrite/text/source_text.h"

#include <algorithm>
#include <map>

namespace symreal::rewrite {
namespace {

// Edits at one character of the original.
struct Here {
  std::string before; // goes in front of it
  std::string after;  // goes behind it
  bool replaced = false;
  std::size_t length = 1; // of the replaced text
  std::string replacement;
};

// Separates new text from adjacent words: a name may follow the `{` of a function directly.
void keep_words_apart(std::string const &original, std::vector<Edit> &edits) {
  for (std::size_t k = 0; k < edits.size(); ++k) {
    std::size_t const begin = edits[k].offset, end = begin + edits[k].length;
    std::string &text = edits[k].text;
    if (text.empty() || end == original.size()) continue;
    bool const meets = k + 1 < edits.size() && edits[k + 1].offset == end;
    char const next = !meets ? original[end] : edits[k + 1].text.empty() ? ' ' : edits[k + 1].text.front();
    bool const are_words = is_word(text.back()) && is_word(next);
    if (are_words && !(is_word(original[end - 1]) && is_word(original[end]))) text += ' ';
    bool const is_first = k == 0 || edits[k - 1].offset + edits[k - 1].length < begin;
    if (is_first && begin > 0 && is_word(original[begin - 1]) && is_word(text.front()) && !is_word(original[begin]))
      text.insert(text.begin(), ' ');
  }
}

} // namespace

std::vector<Edit> compose(std::string const &original, std::vector<Rewording> rewordings) {
  // Outer first: their opening text comes first, their closing text last.
  std::sort(rewordings.begin(), rewordings.end(), [](Rewording const &a, Rewording const &b) {
    if (a.begin != b.begin) return a.begin < b.begin;
    if (a.end != b.end) return a.end > b.end;
    if (a.replaces != b.replaces) return b.replaces;
    if (a.depth != b.depth) return a.depth < b.depth;
    return a < b;
  });
  std::map<std::size_t, Here> characters;
  for (Rewording const &one : rewordings) {
    internal_check(one.begin < one.end && one.end <= original.size());
    if (!one.replaces)
      characters[one.begin].before += one.before;
    else {
      Here &here = characters[one.begin];
      here.replaced = true;
      here.length = one.end - one.begin;
      here.replacement = one.before;
    }
  }
  // Closing text sits on the last character, or on the start of the replacement that covers it.
  for (Rewording const &one : rewordings) {
    if (one.replaces) continue;
    auto covering = characters.upper_bound(one.end - 1);
    bool const covered = covering != characters.begin() && (--covering)->second.replaced &&
                         covering->first + covering->second.length >= one.end;
    Here &last = covered ? covering->second : characters[one.end - 1];
    last.after = one.after + last.after;
  }
  std::vector<Edit> edits;
  for (auto const &[at, here] : characters) {
    std::string const middle = here.replaced ? here.replacement : original.substr(at, 1);
    edits.push_back({at, here.length, here.before + middle + here.after});
  }
  keep_words_apart(original, edits);
  return edits;
}

std::string apply_edits(std::string const &original, std::vector<Edit> const &edits) {
  std::string text;
  std::size_t at = 0;
  for (Edit const &edit : edits) {
    internal_check(edit.offset >= at);
    text.append(original, at, edit.offset - at);
    text += edit.text;
    at = edit.offset + edit.length;
  }
  return text.append(original, at);
}

} // namespace symreal::rewrite
