#include "rewrite/pragma/configured.h"

#include "rewrite/pragma/function_pragmas.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>
#include <iterator>

namespace symreal::rewrite {
namespace {

using namespace clang;

void report(Facts &facts, DiagnosticId id, Place const &place, std::string message, std::vector<Note> notes = {}) {
  add_diagnostic(facts, {id, place, std::move(message), std::move(notes)});
}

// The words of a type in a fixed order: `double const *` is `const double *`.
std::vector<std::string> type_words(std::string const &text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const is_word = isAsciiIdentifierContinue(text[i]) || text[i] == ':';
    bool const goes_on = i > 0 && is_word && (isAsciiIdentifierContinue(text[i - 1]) || text[i - 1] == ':');
    if (text[i] == ' ') continue;
    if (goes_on)
      words.back() += text[i];
    else
      words.emplace_back(1, text[i]);
  }
  std::sort(words.begin(), words.end());
  return words;
}

// f or f(double const *, int), with all enclosing names; an unnamed namespace is left out.
class FunctionName {
public:
  explicit FunctionName(std::string const &text) {
    constexpr std::string_view call_operator = "operator()";
    std::size_t const call = text.find(call_operator), name_end = call == text.npos ? 0 : call + call_operator.size();
    std::size_t const open = text.ends_with(')') ? text.find('(', name_end) : text.npos;
    name_ = llvm::StringRef(text).substr(0, open).trim().str();
    if (name_.starts_with("::")) name_ = name_.substr(2);
    if (open == text.npos) return;
    types_.emplace();
    std::string const list = text.substr(open + 1, text.size() - open - 2);
    int depth = 0;
    std::string type;
    for (char c : list) {
      depth += (c == '<' || c == '(' || c == '[') - (c == '>' || c == ')' || c == ']');
      if (c != ',' || depth > 0)
        type += c;
      else
        types_->push_back(std::exchange(type, {}));
    }
    if (!llvm::StringRef(type).trim().empty()) types_->push_back(type);
  }

  bool names(FunctionDecl const *function) const {
    return (qualified(function) == name_ || qualified(function, true) == name_) &&
           (!types_ || has_types(function, *types_));
  }
  // Name without parameter types.
  std::string const &name() const { return name_; }
  static std::string qualified(FunctionDecl const *function, bool with_inline_namespaces = false) {
    PrintingPolicy policy(function->getASTContext().getLangOpts());
    if (with_inline_namespaces) policy.SuppressInlineNamespace = false;
    std::string name;
    llvm::raw_string_ostream out(name);
    function->printQualifiedName(out, policy);
    for (std::string const unnamed = "(anonymous namespace)::"; name.find(unnamed) != name.npos;)
      name.erase(name.find(unnamed), unnamed.size());
    return name;
  }

private:
  static bool has_types(FunctionDecl const *function, std::vector<std::string> const &types) {
    if (types.size() != function->getNumParams()) return false;
    PrintingPolicy const policy(function->getASTContext().getLangOpts());
    for (unsigned i = 0; i < function->getNumParams(); ++i) {
      QualType const type = function->getParamDecl(i)->getType();
      std::vector<std::string> const wanted = type_words(types[i]);
      if (wanted != type_words(type.getAsString(policy)) &&
          wanted != type_words(type.getCanonicalType().getAsString(policy)))
        return false;
    }
    return true;
  }

  std::string name_;
  std::optional<std::vector<std::string>> types_;
};

// Writes configured clauses as the tokens of a directive, each at its place in the configuration.
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

// function CLAUSE(items)
PragmaWords function_words(ConfiguredClause const &clause, ASTContext &context) {
  Writer writer(context);
  writer.source({"function", clause.name.place});
  writer.clause(clause);
  return std::move(writer.words);
}

// external(FUNCTION) [pure] CLAUSE(items) ...
PragmaWords external_words(ConfiguredExternal const &external, ASTContext &context) {
  Writer writer(context);
  writer.clause({{"external", external.function.place}, {external.function}});
  if (external.pure) writer.source({"pure", external.function.place});
  if (!external.derivatives.empty()) writer.clause({{"derivative", external.function.place}, external.derivatives});
  for (ConfiguredClause const &clause : external.clauses) writer.clause(clause);
  return std::move(writer.words);
}

// The clauses of a kernel, each read by itself so that no item can end its clause.
bool read_clauses(ConfiguredKernel const &kernel, Span const &span, ASTContext &context, PragmaFact &fact,
                  std::vector<PragmaIndex::Name> &names, Facts &facts) {
  for (ConfiguredClause const &clause : kernel.clauses) {
    PragmaWords const words = function_words(clause, context);
    auto const parsed = parse_pragma(words.tokens);
    if (auto const *error = std::get_if<PragmaError>(&parsed)) {
      report(facts, error->id, words.places[std::min(error->token, words.places.size() - 1)], error->message);
      return false;
    }
    auto const &pragma = std::get<Pragma>(parsed);
    if (pragma.clauses.size() != 1) {
      report(facts, DiagnosticId::pragma_syntax, words.places[pragma.clauses[1].name],
             "an item of '" + clause.name.text + "' ends before this");
      return false;
    }
    add_clauses(fact, pragma, words, span, names);
  }
  return true;
}

// Whether the entry only adds clauses that the source's pragma lacks.
bool only_adds(ConfiguredKernel const &kernel) {
  return !kernel.clauses.empty() &&
         std::all_of(kernel.clauses.begin(), kernel.clauses.end(), [](ConfiguredClause const &clause) {
           std::optional<Clause> const known = find_clause(clause.name.text);
           return known && info(*known).has(trait::KEPT);
         });
}

bool has_clauses_of(PragmaFact const &pragma, ConfiguredKernel const &kernel) {
  if (kernel.clauses.empty()) return false;
  std::string const place = to_string(kernel.clauses.front().name.place);
  return std::any_of(pragma.clauses.begin(), pragma.clauses.end(),
                     [&](ClauseFact const &clause) { return to_string(clause.place) == place; });
}

class Kernels {
public:
  Kernels(SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts)
      : map_(map),
        reals_(reals),
        scalars_(scalars),
        facts_(facts) {}

  void attach(ConfiguredKernel const &kernel, std::size_t index, FunctionDecl const *function) {
    std::optional<Span> const brace = map_.token(block_of(function)->getBeginLoc());
    if (!brace) return; // outside the roots, or made by a macro: it cannot be rewritten
    if (!kernel.file.empty() && kernel.file != brace->file) return;
    for (auto &[span, pragma] : facts_.pragmas)
      if (!pragma.function.empty() && pragma.function[0].brace == entry_of(function, map_) &&
          pragma.configured != index)
        return add_to(kernel, function, span, pragma);
    if (facts_.pragmas.count(*brace) != 0) return;
    PragmaFact fact;
    fact.span = *brace;
    fact.place = kernel.function.place;
    fact.display_file = map_.place(function->getLocation()).file;
    fact.is_function = true;
    fact.configured = index;
    std::vector<PragmaIndex::Name> names;
    if (!read_clauses(kernel, *brace, function->getASTContext(), fact, names, facts_)) return;
    for (ClauseFact &clause : fact.clauses)
      for (ItemFact &item : clause.items)
        if (means_file(clause.clause, item))
          item.place = map_.place(function->getLocation()); // it is in no file itself
    facts_.pragmas.emplace(*brace, std::move(fact));
    attach_pragma(*brace, function, names, map_, reals_, scalars_, facts_);
  }

private:
  void add_to(ConfiguredKernel const &kernel, FunctionDecl const *function, Span const &span, PragmaFact &pragma) {
    if (pragma.configured || !only_adds(kernel))
      return report(facts_, DiagnosticId::configured_function, kernel.function.place,
                    "'" + kernel.function.text +
                        "' has a pragma already, to which only constants and scratch can be added",
                    {{pragma.place, "here"}});
    if (has_clauses_of(pragma, kernel)) return;
    std::vector<PragmaIndex::Name> names;
    if (read_clauses(kernel, span, function->getASTContext(), pragma, names, facts_))
      attach_pragma(span, function, names, map_, reals_, scalars_, facts_);
  }

  SourceMap const &map_;
  Reals const &reals_;
  ScalarState const &scalars_;
  Facts &facts_;
};

bool has_error_in(Facts const &facts, std::string const &file) {
  return std::any_of(facts.diagnostics.begin(), facts.diagnostics.end(),
                     [&](symreal::Diagnostic const &one) { return one.place.file == file; });
}

} // namespace

void index_configured_externals(Request const &request, ASTContext &context, PragmaIndex &index, Facts &facts) {
  for (std::size_t i = 0; i < request.externals.size(); ++i) {
    PragmaWords const words = external_words(request.externals[i], context);
    auto parsed = parse_external(words.tokens, words.places);
    if (auto const *error = std::get_if<PragmaError>(&parsed)) {
      report(facts, error->id, words.places[std::min(error->token, words.places.size() - 1)], error->message);
      continue;
    }
    index.externals.push_back(std::get<ExternalPragma>(std::move(parsed)));
    index.externals.back().configured = i;
  }
}

void attach_configured_kernels(Request const &request, std::vector<FunctionDecl const *> const &definitions,
                               SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts) {
  Kernels kernels(map, reals, scalars, facts);
  for (FunctionDecl const *function : definitions)
    if (block_of(function) && map.token(block_of(function)->getBeginLoc()))
      facts.kernel_functions.insert({FunctionName::qualified(function), FunctionName::qualified(function, true)});
  for (std::size_t i = 0; i < request.kernels.size(); ++i) {
    FunctionName const name(request.kernels[i].function.text);
    for (FunctionDecl const *function : definitions)
      if (block_of(function) && name.names(function)) kernels.attach(request.kernels[i], i, function);
  }
}

std::string configured_name(ConfiguredKernel const &kernel) { return FunctionName(kernel.function.text).name(); }

void report_configured(Request const &request, Facts &facts) {
  for (std::size_t i = 0; i < request.kernels.size(); ++i) {
    ConfiguredText const &function = request.kernels[i].function;
    std::vector<Note> found;
    for (auto const &[span, pragma] : facts.pragmas)
      if (!pragma.function.empty() && (pragma.configured == i || has_clauses_of(pragma, request.kernels[i]))) {
        found.push_back({place_in(facts.files.at(span.file), span.begin), pragma.function[0].signature.declaration});
      }
    if (found.size() > 1)
      report(facts, DiagnosticId::configured_function, function.place,
             "'" + function.text + "' is the name of " + std::to_string(found.size()) + " functions", found);
    else if (found.empty() && !has_error_in(facts, function.place.file))
      report(facts, DiagnosticId::configured_function, function.place,
             "no source within the roots defines a function '" + function.text + "'");
  }
  for (std::size_t i = 0; i < request.externals.size(); ++i)
    if (ConfiguredText const &function = request.externals[i].function;
        facts.configured_externals.count(i) == 0 && !has_error_in(facts, function.place.file))
      report(facts, DiagnosticId::configured_function, function.place,
             "no source declares a function '" + function.text + "'");
}

} // namespace symreal::rewrite
