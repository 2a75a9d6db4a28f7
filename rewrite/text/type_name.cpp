#include "rewrite/text/type_name.h"

#include "rewrite/text/source_text.h"

#include <algorithm>
#include <string_view>

namespace symreal::rewrite {
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
  std::size_t end = 0;
  for (RawToken const &token : raw_tokens(text)) {
    if (token.kind != RawToken::Kind::word) continue;
    std::string const word = text.substr(token.begin, token.end - token.begin);
    result.append(text, end, token.begin - end);
    bool const is_member = has_members || result.ends_with('.') || result.ends_with("->");
    bool const is_renamed = names.all.contains(word) || (!is_member && names.at_file_scope.contains(word));
    result += is_renamed ? "SYMREAL_REAL_NAME(" + word + ")" : word;
    end = token.end;
  }
  return result.append(text, end);
}

} // namespace symreal::rewrite
