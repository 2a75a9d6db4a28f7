// Walk over the fields of a language (fields.def): each_field calls visit(key, field, places) for each key of a table,
// with the places of a pattern, nullopt for a field that is not a pattern.
#pragma once

#include "engine/emit/language/language.h"

#include <optional>

namespace symreal {

#define SYNTAX(type) template <class Visit> void each_field(type &syntax, Visit const &visit) {
#define TEXT(name, value) visit(#name, syntax.name, std::nullopt);
#define PATTERN(name, places) visit(#name, syntax.name, std::optional<std::string_view>(places));
#define FIELD(type, name, value) visit(#name, syntax.name, std::nullopt);
#define MEMBER(type, name, value)
#define IS_GIVEN(condition)
#define END(type) }
#include "engine/emit/language/fields.def"

template <class Visit> void each_field(NameRules &rules, Visit const &visit) {
  visit("keywords", rules.keywords, std::nullopt);
  visit("ignores_case", rules.ignores_case, std::nullopt);
  visit("has_underscores", rules.has_underscores, std::nullopt);
}

} // namespace symreal
