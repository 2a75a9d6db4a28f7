#include "rewrite/pragma/item_bounds.h"

#include "rewrite/facts/merge.h"
#include "rewrite/text/source_text.h"

namespace symreal::rewrite {
namespace {

std::string replaced(std::string text, std::string const &from, std::string const &to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Index of section k in an item's expression.
std::string index_of(Section const &section, std::size_t k) {
  return "(" + section.low + ")+symreal_i[" + std::to_string(k) + "]";
}

// A part of the expression as the user writes it, with [low:length].
std::string written(std::string text, std::vector<Section> const &sections) {
  for (std::size_t k = 0; k < sections.size(); ++k)
    text = replaced(std::move(text), "[" + index_of(sections[k], k) + "]",
                    "[" + sections[k].low + ":" + sections[k].length + "]");
  return text;
}

// The elements that one pair of brackets names, where declarations tell.
struct Elements {
  std::optional<std::int64_t> first, count;
  bool are_within(std::int64_t all) const {
    return *count == 0 || (*first >= 0 && *count > 0 && *first <= all - *count);
  }
};

Elements elements(std::string const &index, std::vector<Section> const &sections, LookUp look_up) {
  for (std::size_t k = 0; k < sections.size(); ++k)
    if (index == index_of(sections[k], k))
      return {constant_of(sections[k].low, look_up), constant_of(sections[k].length, look_up)};
  return {constant_of(index, look_up), 1};
}

class Bounds {
public:
  Bounds(ItemFact &item, LookUp look_up, Facts &facts) : item_(item), look_up_(look_up), facts_(facts) {}

  // Processes indices from left to right: tests inserted before a bracket shift later ones by `shift_`.
  void note(std::vector<ItemIndex> const &indices) {
    std::string tested = item_.expression;
    for (ItemIndex const &index : indices) {
      if (index.is_unbounded) continue;
      std::string const object = item_.expression.substr(index.object, index.open - index.object);
      std::string const inner = item_.expression.substr(index.open + 1, index.close - index.open - 1);
      Elements const named = elements(inner, item_.sections, look_up_);
      if (index.count && named.first && named.count) {
        if (named.are_within(*index.count)) continue;
        refuse(written(object, item_.sections), *index.count);
      }
      test(tested, index, object, inner); // refused ones, too: the original does not rely on them
    }
    if (tested != item_.expression) item_.tested = tested;
  }

private:
  void refuse(std::string const &object, std::int64_t count) {
    add_diagnostic(facts_, {DiagnosticId::section_beyond, item_.place, beyond_message(item_.label, object, count)});
  }

  // Earlier tests stand before this bracket, in the object or in front of it.
  void test(std::string &tested, ItemIndex const &index, std::string const &object, std::string const &inner) {
    std::string const name = in_quotes(written(object, item_.sections));
    std::size_t const behind = item_.expression.size() - index.close; // with the bracket
    std::size_t const close = tested.size() - behind, open = close - inner.size() - 1;
    if (index.count) {
      tested.replace(open + 1, inner.size(),
                     "SYMREAL_INDEX(" + std::to_string(*index.count) + ", " + name + ", " + inner + ")");
      return;
    }
    std::size_t const begin = index.object; // indices within an object follow the object itself
    std::string const now = tested.substr(begin, open - begin);
    tested.replace(begin, close + 1 - begin, "SYMREAL_ELEMENT(" + name + ", (" + inner + "), " + now + ")");
  }

  ItemFact &item_;
  LookUp look_up_;
  Facts &facts_;
};

} // namespace

void note_bounds(ClauseFact const &clause, ItemFact &item, std::vector<ItemIndex> const &indices, LookUp look_up,
                 Facts &facts) {
  bool const names_objects = info(clause.clause).has(trait::OBJECTS) || clause.clause == Clause::implicit;
  if ((!names_objects && clause.clause != Clause::table) || item.expression.starts_with('&')) return;
  Bounds(item, look_up, facts).note(indices);
}

} // namespace symreal::rewrite
