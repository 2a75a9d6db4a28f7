#include "rewrite/decide/decide.h"

#include <algorithm>
#include <stdexcept>

namespace symreal::rewrite {
namespace {

std::string words(Passive why) {
  switch (why) {
  case not_passive: return "of a type that is not double";
  case constant_variable: return "constexpr";
  case static_member: return "a static const member with its value in the class";
  case external_declaration: return "a declaration of an external function";
  case template_value: return "a template parameter that is a value";
  case static_assertion: return "static_assert";
  case enumerator: return "the value of an enumerator";
  case constant_expression: return "a constant expression";
  case array_bound: return "the bound of an array";
  case plain_template: return "an argument of a template that counts in plain numbers";
  case long_double: return "long double is left as it is";
  case complex_double: return "a C complex type";
  case dropped_argument: return "an argument that its macro drops";
  case macro_name: return "the name of a macro";
  }
  internal_failure("each reason has words", __FILE__, __LINE__);
}

// Offsets to places, for many places of one file in the order of their offsets.
class Lines {
public:
  explicit Lines(FileFact const &file) : file_(file) {}
  Place place(std::size_t offset) {
    for (; at_ < offset; ++at_)
      if (file_.text[at_] == '\n') {
        ++line_;
        start_ = at_ + 1;
      }
    return {file_.display_path, line_, static_cast<unsigned>(offset - start_) + 1};
  }

private:
  FileFact const &file_;
  std::size_t at_ = 0, start_ = 0;
  unsigned line_ = 1;
};

} // namespace

Ledger::Ledger(Facts const &facts) : facts_(facts) {
  for (auto const &[span, pragma] : facts.pragmas)
    if (!pragma.configured) pragmas_.insert(span);
  for (auto const &[path, file] : facts.files)
    for (SpelledType const &type : file.spelled) {
      if (type.kept) kept_.insert(type.span);
      if (type.is_long) long_.insert(type.span);
    }
}

Spelling Ledger::judged(Span const &span, TypeToken const &token) const {
  auto const make = [&](Fate fate, std::string reason, std::optional<DiagnosticId> id = {}) {
    return Spelling{{}, "double", fate, std::move(reason), id ? code(*id) : ""};
  };
  if (meets(kept_, span)) return make(Fate::passive, "kept by a comment");
  if (meets(facts_.quoted, span)) return make(Fate::passive, "a macro turns it into text", DiagnosticId::quoted_double);
  switch (token.fate) {
  case Fate::converted: return make(token.fate, {});
  case Fate::diagnosed: return make(token.fate, words(token.why), DiagnosticId::unconvertible_type);
  case Fate::follows:
    if (long_.contains(span)) return make(Fate::passive, words(long_double));
    return make(token.fate, "follows its neighbours", DiagnosticId::unaccounted_double);
  default: return make(Fate::passive, words(token.why));
  }
}

// The outermost part of an #if around it that was not taken, in the source that came closest to it.
std::string Ledger::condition(SpelledType const &type) const {
  Span const &span = type.span;
  FileFact const &file = facts_.files.at(span.file);
  for (auto at = facts_.skipped.upper_bound(span); at != facts_.skipped.begin();) {
    --at;
    if (at->file != span.file) break;
    if (at->end < span.end) continue;
    // Parts of the same #if that follow one another are skipped together.
    auto const part = std::find_if(type.within.begin(), type.within.end(),
                                   [&](std::size_t directive) { return directive >= at->begin; });
    return part == type.within.end() ? "#if" : file.conditions.at(*part);
  }
  return {};
}

Spelling Ledger::entry(FileFact const &file, SpelledType const &type) const {
  using Where = SpelledType::Where;
  std::string const name = type.is_float ? "float" : type.is_long ? "long double" : "double";
  auto const make = [&](Fate fate, std::string reason, std::string detail = {}) {
    return Spelling{{}, name, fate, std::move(reason), std::move(detail)};
  };
  Span const &span = type.span;
  bool const is_double = !type.is_float && !type.is_long;
  auto const token = facts_.types.find(span);
  bool const is_known = token != facts_.types.end(), reached = is_known && token->second.fate != Fate::inactive;
  if (type.where == Where::directive || meets(pragmas_, span)) return make(Fate::passive, "in a directive", type.name);
  if (reached && is_double) return judged(span, token->second);
  if (!reached)
    if (std::string const directive = condition(type); !directive.empty())
      return make(Fate::inactive, "not compiled", directive);
  if (type.is_float) return make(Fate::passive, "float is left as it is");
  if (type.is_long) return make(Fate::passive, words(long_double));
  if (type.where == Where::macro) return make(Fate::inactive, "in a macro that is not expanded", type.name);
  if (meets(facts_.quoted, span)) return make(Fate::passive, "a macro turns it into text");
  if (is_known) return make(Fate::passive, words(token->second.why));
  throw std::logic_error(to_string(place_in(file, span.begin)) + ": this '" + name +
                         "' is in none of the ledger's columns");
}

std::vector<Spelling> Ledger::entries(std::string const &path, std::vector<Edit> const &edits) const {
  FileFact const &file = facts_.files.at(path);
  std::vector<Spelling> entries;
  Lines lines(file);
  for (SpelledType const &type : file.spelled) {
    entries.push_back(entry(file, type));
    Spelling &added = entries.back();
    added.place = lines.place(type.span.begin);
    auto const edit = std::lower_bound(edits.begin(), edits.end(), type.span.begin,
                                       [](Edit const &one, std::size_t offset) { return one.offset < offset; });
    bool const edited =
        edit != edits.end() && edit->offset == type.span.begin && edit->length == type.span.end - type.span.begin;
    internal_check(edited == (added.fate == Fate::converted || added.fate == Fate::follows));
  }
  return entries;
}

} // namespace symreal::rewrite
