#include "rewrite/pragma/pragma_handler.h"

#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

ItemFact item_fact(std::vector<PragmaToken> const &tokens, PragmaItem const &item) {
  ItemFact fact;
  fact.label = text_of(tokens, item.tokens);
  fact.expression = element_text(tokens, item);
  fact.base = base_text(tokens, item);
  for (PragmaSection const &section : item.sections)
    fact.sections.push_back(
        {section.low.empty() ? "0" : text_of(tokens, section.low), text_of(tokens, section.length)});
  fact.is_return = fact.label == "return";
  std::size_t const next = item.tokens.begin + 1;
  bool const name_first = tokens[item.tokens.begin].is_name && !fact.is_return;
  fact.section_on_base = name_first && !item.sections.empty() && item.sections[0].brackets.begin == next;
  fact.base_is_name = name_first && (next == item.tokens.end || fact.section_on_base);
  return fact;
}

// Every name that is looked up by itself: not after `.`, `->` or `::`, and not before `::`.
void collect_names(PragmaWords const &words, PragmaItem const &item, ItemKey const &key,
                   std::vector<PragmaIndex::Name> &names) {
  auto const is = [&](std::size_t i, std::string const &text) {
    return i < words.tokens.size() && words.tokens[i].text == text;
  };
  for (std::size_t i = item.tokens.begin; i < item.tokens.end; ++i) {
    if (!words.names[i]) continue;
    if (i > 0 && (is(i - 1, ".") || is(i - 1, "->") || is(i - 1, "::"))) continue;
    if (is(i + 1, "::")) continue;
    names.push_back({words.tokens[i].text, words.places[i], key, i == item.tokens.begin});
  }
}

class Handler : public PragmaHandler {
public:
  Handler(SourceMap const &map, Facts &facts, PragmaIndex &index)
      : PragmaHandler("symreal"),
        map_(map),
        facts_(facts),
        index_(index) {}

  void HandlePragma(Preprocessor &preprocessor, PragmaIntroducer introducer, Token &) override {
    std::vector<Token> lexed;
    Token token;
    for (preprocessor.LexUnexpandedToken(token); token.isNot(tok::eod); preprocessor.LexUnexpandedToken(token))
      lexed.push_back(token);
    if (introducer.Kind != PIK_HashPragma) {
      report(DiagnosticId::pragma_syntax, introducer.Loc,
             "_Pragma(\"symreal ...\") cannot be rewritten; write #pragma");
      return;
    }
    PragmaWords words;
    for (Token const &one : lexed) {
      IdentifierInfo const *name = one.getIdentifierInfo();
      words.tokens.push_back(
          {preprocessor.getSpelling(one), name != nullptr, one.hasLeadingSpace() || one.isAtStartOfLine()});
      words.places.push_back(map_.place(one.getLocation()));
      words.names.push_back(one.is(tok::identifier) && !name->hasMacroDefinition());
    }
    std::vector<PragmaToken> const &tokens = words.tokens;
    SourceLocation const end = lexed.empty() ? token.getLocation() : lexed.back().getEndLoc();
    std::optional<Span> const span = map_.characters(introducer.Loc, end);
    if (!span) {
      report(DiagnosticId::pragma_outside_roots, introducer.Loc, "this pragma is in a file outside the roots");
      return;
    }
    if (!tokens.empty() && tokens[0].text == "external") {
      collect_external(words, *span, introducer.Loc, end);
      return;
    }
    auto const parsed = parse_pragma(tokens);
    if (auto const *error = std::get_if<PragmaError>(&parsed)) {
      report(error->id, error->token < lexed.size() ? lexed[error->token].getLocation() : end, error->message);
      facts_.pragmas[*span].span = *span;
      return;
    }
    auto const &pragma = std::get<Pragma>(parsed);
    collect(pragma, words, *span, introducer.Loc);
    PragmaFact const &fact = facts_.pragmas[*span];
    bool const has_setting = std::ranges::any_of(
        fact.clauses, [](ClauseFact const &clause) { return info(clause.clause).has(trait::SETTING); });
    if (!pragma.is_function && has_setting) index_.statement_pragmas[*span] = introducer.Loc;
    if (pragma.is_function)
      index_.function_pragmas[*span] = introducer.Loc;
    else if (index_.ask_compiler)
      inject(preprocessor, pragma, lexed, *span);
  }

private:
  void report(DiagnosticId id, SourceLocation location, std::string message) {
    facts_.diagnostics.push_back({id, map_.place(location), std::move(message)});
  }

  std::size_t continued_lines(Span const &span, SourceLocation start) const {
    return static_cast<std::size_t>(std::ranges::count(map_.text(span, start), '\n'));
  }

  void collect_external(PragmaWords const &words, Span const &span, SourceLocation start, SourceLocation end) {
    PragmaFact &fact = facts_.pragmas[span];
    fact.span = span;
    fact.continued_lines = continued_lines(span, start);
    auto parsed = parse_external(words.tokens, words.places);
    if (auto const *error = std::get_if<PragmaError>(&parsed))
      facts_.diagnostics.push_back({error->id,
                                    error->token < words.places.size() ? words.places[error->token] : map_.place(end),
                                    error->message});
    else
      index_.externals.push_back(std::get<ExternalPragma>(std::move(parsed)));
  }

  void collect(Pragma const &pragma, PragmaWords const &words, Span const &span, SourceLocation start) {
    PragmaFact fact;
    fact.span = span;
    fact.place = map_.place(start);
    fact.is_function = pragma.is_function;
    fact.display_file = fact.place.file;
    fact.continued_lines = continued_lines(span, start);
    add_clauses(fact, pragma, words, span, index_.function_names);
    facts_.pragmas.try_emplace(span, std::move(fact)); // a header's pragma may have been met before
  }

  void inject(Preprocessor &preprocessor, Pragma const &pragma, std::vector<Token> const &lexed, Span const &span) {
    std::vector<Token> stream;
    for (std::size_t c = 0; c < pragma.clauses.size(); ++c)
      for (std::size_t i = 0; is_looked_up(pragma.clauses[c], lexed) && i < pragma.clauses[c].items.size(); ++i) {
        PragmaItem const &item = pragma.clauses[c].items[i];
        ClauseFact const &clause = facts_.pragmas[span].clauses[c];
        if (means_file(clause.clause, clause.items[i])) continue;
        SourceLocation const at = lexed[item.tokens.begin].getLocation();
        index_.statements[at.getRawEncoding()] = {span, c, i};
        open(preprocessor, stream, at);
        std::size_t next = item.tokens.begin;
        for (PragmaSection const &section : item.sections) {
          append(stream, lexed, {next, section.brackets.begin + 1});
          if (section.low.empty()) stream.push_back(zero(lexed[section.brackets.begin].getLocation()));
          append(stream, lexed, section.low);
          append(stream, lexed, {section.brackets.end - 1, section.brackets.end});
          next = section.brackets.end;
        }
        append(stream, lexed, {next, item.tokens.end});
        close(stream, at);
        for (PragmaSection const &section : item.sections) {
          SourceLocation const length = lexed[section.length.begin].getLocation();
          open(preprocessor, stream, length);
          append(stream, lexed, section.length);
          close(stream, length);
        }
      }
    if (stream.empty()) return;
    auto tokens = std::make_unique<Token[]>(stream.size());
    std::copy(stream.begin(), stream.end(), tokens.get());
    preprocessor.EnterTokenStream(std::move(tokens), static_cast<unsigned>(stream.size()),
                                  /*DisableMacroExpansion=*/false, /*IsReinject=*/false);
  }

  static bool is_looked_up(PragmaClause const &clause, std::vector<Token> const &lexed) {
    IdentifierInfo const *name = lexed[clause.name].getIdentifierInfo();
    std::optional<Clause> const known = name ? find_clause(name->getName()) : std::nullopt;
    return !known || !info(*known).has(trait::SETTING);
  }

  static void append(std::vector<Token> &stream, std::vector<Token> const &lexed, TokenRange range) {
    for (std::size_t i = range.begin; i < range.end; ++i) stream.push_back(lexed[i]);
  }

  static Token punctuation(tok::TokenKind kind, SourceLocation at) {
    Token token;
    token.startToken();
    token.setKind(kind);
    token.setLocation(at);
    token.setLength(1);
    return token;
  }

  static Token zero(SourceLocation at) {
    Token token = punctuation(tok::numeric_constant, at);
    token.setLiteralData("0");
    return token;
  }

  static void open(Preprocessor &preprocessor, std::vector<Token> &stream, SourceLocation at) {
    stream.push_back(punctuation(tok::l_paren, at));
    Token nothing = punctuation(tok::kw_void, at);
    nothing.setIdentifierInfo(preprocessor.getIdentifierInfo("void"));
    stream.push_back(nothing);
    stream.push_back(punctuation(tok::r_paren, at));
    stream.push_back(punctuation(tok::l_paren, at));
  }

  static void close(std::vector<Token> &stream, SourceLocation at) {
    stream.push_back(punctuation(tok::r_paren, at));
    stream.push_back(punctuation(tok::semi, at));
  }

  SourceMap const &map_;
  Facts &facts_;
  PragmaIndex &index_;
};

} // namespace

void add_clauses(PragmaFact &fact, Pragma const &pragma, PragmaWords const &words, Span const &span,
                 std::vector<PragmaIndex::Name> &names) {
  for (PragmaClause const &clause : pragma.clauses) {
    ClauseFact &clause_fact = fact.clauses.emplace_back();
    clause_fact.clause = *find_clause(words.tokens[clause.name].text); // as the parser has found
    clause_fact.place = words.places[clause.name];
    clause_fact.argument = text_of(words.tokens, clause.arguments);
    for (PragmaItem const &item : clause.items) {
      clause_fact.items.push_back(item_fact(words.tokens, item));
      clause_fact.items.back().place = words.places[item.tokens.begin];
      if (means_file(clause_fact.clause, clause_fact.items.back())) {
        clause_fact.items.back().seen = true;
        continue;
      }
      if (pragma.is_function && !info(clause_fact.clause).has(trait::SINGLE))
        collect_names(words, item, {span, fact.clauses.size() - 1, clause_fact.items.size() - 1}, names);
    }
  }
}

std::unique_ptr<PragmaHandler> make_pragma_handler(SourceMap const &map, Facts &facts, PragmaIndex &index) {
  return std::make_unique<Handler>(map, facts, index);
}

} // namespace symreal::rewrite
