#include "engine/emit/c/objects.h"

#include <cctype>
#include <fmt/format.h>

namespace symreal {

// Declares numbers, or untagged structs of them: a struct of numbers alone has no padding.
static std::string declare(Language const &language, std::string const &indent, std::string const &name,
                           std::vector<std::size_t> const &extents, std::vector<Member> const &members) {
  if (number_count(extents, members) == 0) return {};
  std::string text = indent + (members.empty() ? std::string(language.number.name) + " " : "struct {\n");
  std::vector<std::string> const names = identifiers(members, language.names);
  for (std::size_t i = 0; i < members.size(); ++i)
    text += declare(language, indent + "  ", names[i], members[i].extents, members[i].members);
  if (!members.empty()) text += indent + "} ";
  text += name;
  for (std::size_t extent : extents) text += fmt::format("[{}]", extent);
  return text + ";\n";
}

ObjectTexts c_objects(Emission const &emission, std::string const &role, std::vector<Object> const &objects) {
  std::vector<std::string> const names = identifiers(objects, emission.language.names);
  ObjectTexts texts;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].count == 0) continue;
    if (!texts.indices.empty()) texts.indices += ",";
    texts.indices += fmt::format("\n  {} = {}", emission.name(role + "_" + names[i]), objects[i].first);
    texts.members += declare(emission.language, "  ", names[i], objects[i].extents, objects[i].members);
  }
  return texts;
}

std::string include_guard(Emission const &emission, std::string const &suffix) {
  std::string name = prefixed(emission.options, emission.options.base_name) + suffix;
  for (char &c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
  return std::isdigit(static_cast<unsigned char>(name[0])) ? "H_" + name : name;
}

} // namespace symreal
