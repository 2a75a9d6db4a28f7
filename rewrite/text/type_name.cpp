#include "rewrite/text/type_name.h"

#include "rewrite/text/source_text.h"

#include <algorithm>
#include <string_view>

namespace symreal::rewrite {
namespace {

std::size_t end_of_word(std::string const &text, std::size_t begin) {
  std::size_t at = begin;
  while (at < text.size() && is_word(text[at])) ++at;
  return at;
}

} // namespace

std::string choose_type_name(Request const &request, Facts const &facts, std::vector<Diagnostic> &diagnostics) {
  auto const refuse = [&](Place const &place, std::string const &name) {
    diagnostics.push_back({DiagnosticId::reserved_name, place, "the sources already use the name '" + name + "'"});
  };
  bool usual_is_taken = false;
  for (auto const &[name, place] : facts.taken_names) {
    if (name.starts_with("SYMREAL_"))
      refuse(place, name);
    else if (name == usual_type_name || name.starts_with(std::string(usual_type_name) + "_"))
      usual_is_taken = true;
    if (name == request.type_name || (request.type_name == usual_type_name && !name.starts_with("SYMREAL_")))
      refuse(place, name);
  }
  if (!request.type_name.empty()) return request.type_name;
  return usual_is_taken ? reserved_type_name : usual_type_name;
}

std::string with_type_name(std::string const &text, std::string const &type_name) {
  constexpr std::string_view stem = reserved_type_name;
  std::string result;
  std::size_t at = 0;
  for (std::size_t found; (found = text.find(stem, at)) != text.npos; at = found + stem.size()) {
    bool const begins = found == 0 || !is_word(text[found - 1]);
    char const next = found + stem.size() < text.size() ? text[found + stem.size()] : ' ';
    bool const is_type = begins && !is_word(next);
    bool const is_macro = begins && next == '_' && type_name == usual_type_name;
    result.append(text, at, found - at).append(is_type || is_macro ? type_name : stem);
  }
  return result.append(text, at);
}

std::string with_renamed(std::string const &text, RenamedNames const &names) {
  bool const has_members = text.starts_with(" SYMREAL_REAL_MEMBERS(") || text.starts_with(" SYMREAL_REAL_LAYOUT(");
  std::string result;
  for (std::size_t at = 0, end; at < text.size(); at = end) {
    bool const is_literal = text[at] == '"' || text[at] == '\'';
    end = is_literal ? end_of_literal(text, at) : std::max(end_of_word(text, at), at + 1);
    std::string const word = text.substr(at, end - at);
    bool const is_member = has_members || result.ends_with('.') || result.ends_with("->");
    bool const is_renamed = names.all.contains(word) || (!is_member && names.at_file_scope.contains(word));
    result += is_renamed ? "SYMREAL_REAL_NAME(" + word + ")" : word;
  }
  return result;
}

} // namespace symreal::rewrite
