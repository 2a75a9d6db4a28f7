#include "rewrite/pragma/configured_words.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Writer {
public:
  explicit Writer(ASTContext &context) : context_(context) {}

  void punctuation(std::string const &text, Place const &place) { add({text, false, false}, place, false); }

  void source(ConfiguredText const &from) {
    std::string const &text = from.text;
    Lexer lexer(SourceLocation(), context_.getLangOpts(), text.data(), text.data(), text.data() + text.size());
    Token token;
    for (lexer.LexFromRawLexer(token); token.isNot(tok::eof); lexer.LexFromRawLexer(token)) {
      std::size_t const begin = lexer.getCurrentBufferOffset() - token.getLength();
      std::string const spelled = text.substr(begin, token.getLength());
      Place place = from.place;
      // A text of several lines was folded when it was read, so its columns are unknown.
      if (text.find('\n') == text.npos) place.column += static_cast<unsigned>(begin);
      bool const is_word = token.is(tok::raw_identifier);
      bool is_name = false;
      if (is_word) {
        IdentifierInfo const &name = context_.Idents.get(spelled);
        is_name = name.getTokenID() == tok::identifier && !name.hasMacroDefinition();
      }
      add({spelled, is_word, token.hasLeadingSpace()}, place, is_name);
    }
  }

  void clause(ConfiguredClause const &clause) {
    source(clause.name);
    punctuation("(", clause.name.place);
    for (ConfiguredText const &item : clause.items) {
      if (&item != &clause.items.front()) punctuation(",", item.place);
      source(item);
    }
    punctuation(")", clause.items.empty() ? clause.name.place : clause.items.back().place);
  }

  PragmaWords words;

private:
  void add(PragmaToken token, Place const &place, bool is_name) {
    words.tokens.push_back(std::move(token));
    words.places.push_back(place);
    words.names.push_back(is_name);
  }

  ASTContext &context_;
};

} // namespace

PragmaWords function_words(ConfiguredClause const &clause, ASTContext &context) {
  Writer writer(context);
  writer.source({"function", clause.name.place});
  writer.clause(clause);
  return std::move(writer.words);
}

PragmaWords external_words(ConfiguredExternal const &external, ASTContext &context) {
  Writer writer(context);
  writer.clause({{"external", external.function.place}, {external.function}});
  if (external.pure) writer.source({"pure", external.function.place});
  if (!external.derivatives.empty()) writer.clause({{"derivative", external.function.place}, external.derivatives});
  for (ConfiguredClause const &clause : external.clauses) writer.clause(clause);
  return std::move(writer.words);
}

} // namespace symreal::rewrite
