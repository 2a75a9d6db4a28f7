#include "program/wrapper/baked_shape.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {
namespace {

BakedShape read_shape(std::string_view &text) {
  BakedShape shape;
  while (text.starts_with('[')) {
    std::size_t const end = text.find(']');
    shape.extents.push_back(std::stoul(std::string(text.substr(1, end - 1))));
    text.remove_prefix(end + 1);
  }
  shape.kind = text.front();
  text.remove_prefix(1);
  if (shape.kind != '{') return shape;
  while (!text.starts_with('}')) {
    std::size_t const colon = text.find(':');
    std::string name(text.substr(0, colon));
    text.remove_prefix(colon + 1);
    shape.members.push_back(read_shape(text));
    shape.members.back().name = std::move(name);
    text.remove_prefix(1); // skips the semicolon
  }
  text.remove_prefix(1);
  return shape;
}

std::string loop(std::size_t depth, std::string const &count, std::string const &inner) {
  return fmt::format("{{ unsigned long symreal_{0}; for (symreal_{0} = 0; symreal_{0} < {1}; ++symreal_{0}) {2} }}",
                     depth, count, inner);
}

std::string statements(BakedShape const &shape, std::string element, std::size_t depth, BakedLeaf const &leaf) {
  for (std::size_t k = 0; k < shape.extents.size(); ++k) element += fmt::format("[symreal_{}]", depth + k);
  std::size_t const inside = depth + shape.extents.size();
  std::string text;
  if (shape.kind == '{') {
    for (BakedShape const &inner : shape.members)
      text += statements(inner, element + "." + inner.name, inside, leaf) + " ";
    if (!text.empty()) text = "{ " + text + "}";
  } else
    text = leaf(element, shape.kind);
  if (text.empty()) return "";
  for (std::size_t k = shape.extents.size(); k-- > 0;)
    text = loop(depth + k, std::to_string(shape.extents[k]) + "u", text);
  return text;
}

} // namespace

BakedShape shape_of(rewrite::Baked const &baked) {
  std::string_view text = baked.shape;
  return read_shape(text);
}

std::string written(BakedShape const &shape) {
  std::string text;
  for (std::size_t const extent : shape.extents) text += fmt::format("[{}]", extent);
  text += shape.kind;
  if (shape.kind != '{') return text;
  for (BakedShape const &inner : shape.members) text += inner.name + ":" + written(inner) + ";";
  return text + "}";
}

bool keep_members(BakedShape &shape, std::string const &name,
                  std::function<bool(std::string const &, char)> const &visit) {
  if (shape.kind != '{') return visit(name, shape.kind);
  std::erase_if(shape.members, [&](BakedShape &member) { return !keep_members(member, member.name, visit); });
  return !shape.members.empty();
}

std::string baked_statements(rewrite::Baked const &baked, std::vector<std::string> const &lengths,
                             BakedLeaf const &leaf) {
  BakedShape const shape = shape_of(baked);
  std::string element = "(" + baked.expression + ")";
  for (std::size_t k = 0; k < baked.sections.size(); ++k)
    element += fmt::format("[({}) + symreal_{}]", baked.sections[k].low, k);
  std::string text = statements(shape, element, baked.sections.size(), leaf);
  if (text.empty()) return "";
  for (std::size_t k = baked.sections.size(); k-- > 0;) text = loop(k, lengths[k], text);
  return text;
}

} // namespace symreal::program
