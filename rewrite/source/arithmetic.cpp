#include "rewrite/source/arithmetic.h"

#include "rewrite/text/source_text.h"

#include <algorithm>

namespace symreal::rewrite {
using namespace clang;

namespace {

// Options of gcc that change results of arithmetic. Vectorised sums are also fused, in spite of fp-contract=off.
bool changes_arithmetic(llvm::StringRef option) {
  option = option.trim();
  if (!option.consume_front("-f")) option.consume_front("-");
  constexpr llvm::StringLiteral options[] = {
      "Ofast",           "fast-math",          "unsafe-math-optimizations", "associative-math",
      "reciprocal-math", "finite-math-only",   "no-signed-zeros",           "fp-contract=fast",
      "fp-contract=on",  "cx-limited-range",   "cx-fortran-rules",          "single-precision-constant",
      "tree-vectorize",  "tree-slp-vectorize", "tree-loop-vectorize",       "excess-precision=fast"};
  return llvm::is_contained(options, option) || (option.starts_with("fpmath=") && option.contains("387")) ||
         option == "fpmath=both";
}

// A string literal of options without those; nullopt if no option is removed. `neutral` stands for an empty list.
std::optional<std::string> without_them(llvm::StringRef literal, char const *neutral) {
  if (!literal.consume_front("\"") || !literal.consume_back("\"")) return std::nullopt;
  llvm::SmallVector<llvm::StringRef> words;
  literal.split(words, ',');
  std::string rest;
  for (llvm::StringRef word : words)
    if (!changes_arithmetic(word)) rest += (rest.empty() ? "" : ",") + word.str();
  if (llvm::none_of(words, changes_arithmetic)) return std::nullopt;
  return "\"" + (rest.empty() ? neutral : rest) + "\"";
}

// Replacement of a pragma; nullopt if it may stay. Most compilers ignore pragmas that they do not know.
std::optional<std::string> instead_of(llvm::StringRef pragma) {
  auto const [space, rest] = pragma.split(' ');
  bool changes = false;
  if (space == "GCC" && (rest.starts_with("optimize") || rest.starts_with("target"))) {
    llvm::SmallVector<llvm::StringRef> parts;
    rest.split(parts, '"');
    for (llvm::StringRef part : parts) {
      llvm::SmallVector<llvm::StringRef> words;
      part.split(words, ',');
      changes = changes || llvm::any_of(words, changes_arithmetic);
    }
  } else if (space == "STDC") {
    changes = (rest.starts_with("FP_CONTRACT") || rest.starts_with("CX_LIMITED_RANGE")) && rest.ends_with("ON");
  } else if (space == "clang" && rest.starts_with("fp ")) {
    for (char const *word : {"fast", "contract(on)", "reassociate(on)", "reciprocal(on)", "(extended)"})
      changes = changes || rest.contains(word);
  } else if (space == "clang" && rest.starts_with("loop ")) { // it may regroup the sums of the loop
    for (char const *word : {"vectorize(enable)", "vectorize(assume_safety)", "vectorize_width("})
      changes = changes || rest.contains(word);
    changes = changes && !rest.contains("vectorize_width(1)");
  } else if (pragma.starts_with("float_control")) {
    changes = pragma.contains("precise") && pragma.contains("off");
    if (changes && pragma.contains("push")) return "_Pragma(\"float_control(push)\")";
  } else if (pragma.starts_with("fp_contract")) {
    changes = pragma.contains("on)") || pragma.contains("on )");
  }
  return changes ? std::optional<std::string>("") : std::nullopt;
}

llvm::StringRef name_of(Token const &token) {
  if (token.is(tok::raw_identifier)) return token.getRawIdentifier();
  return token.is(tok::identifier) ? token.getIdentifierInfo()->getName() : llvm::StringRef();
}

// Removes the text, or reports it if it stands outside of the roots.
void note(Facts &facts, std::optional<Span> const &span, ArithmeticFact fact, Place place, std::string const &what) {
  if (!span)
    return add_diagnostic(facts, {DiagnosticId::arithmetic_stays, std::move(place),
                                  what + " changes arithmetic, and its text stands in no file of the roots"});
  if (facts.arithmetic.emplace(*span, std::move(fact)).second)
    add_diagnostic(facts, {DiagnosticId::arithmetic_left_out, std::move(place),
                           what + " is left out, of the reference as well: it changes arithmetic"});
}

class ArithmeticPragmas : public PPCallbacks {
public:
  ArithmeticPragmas(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}

  // Whether the compiler knows the pragma or not, its text suffices here.
  void PragmaDirective(SourceLocation location, PragmaIntroducerKind kind) override {
    if (map_.is_argument_of(location, "REAL_EITHER")) return;
    auto const [file, offset] = map_.sources().getDecomposedSpellingLoc(location);
    llvm::StringRef const text = map_.sources().getBufferData(file);
    if (kind == PIK_HashPragma)
      directive(text, offset, location);
    else if (kind == PIK__Pragma)
      operation(text, offset, location);
  }

  // Clang may skip text that the program's own compiler takes: it does not know all attributes.
  void SourceRangeSkipped(SourceRange range, SourceLocation) override {
    if (!map_.in_roots(range.getBegin())) return;
    SourceManager const &sources = map_.sources();
    auto const [file, begin] = sources.getDecomposedLoc(range.getBegin());
    std::size_t const end = sources.getFileOffset(range.getEnd());
    llvm::StringRef const text = sources.getBufferData(file);
    SourceLocation const start = sources.getLocForStartOfFile(file);
    if (!text.slice(begin, end).contains("optimize") && !text.slice(begin, end).contains("target")) return;
    Lexer lexer(start, map_.language(), text.begin(), text.begin() + begin, text.end());
    ArithmeticAttributes attributes(map_, facts_);
    Token token, before;
    before.startToken();
    while (!lexer.LexFromRawLexer(token) && sources.getFileOffset(token.getLocation()) < end) {
      attributes.token(token);
      if (before.is(tok::hash) && name_of(token) == "pragma")
        directive(text, sources.getFileOffset(before.getLocation()), before.getLocation());
      before = token;
    }
  }

  void EndOfMainFile() override {
    for (std::optional<Outside> const &one : in_force_)
      if (one) note(facts_, std::nullopt, {}, one->place, one->pragma);
  }

private:
  struct Outside {
    Place place;
    std::string pragma;
  };

  // #pragma words
  void directive(llvm::StringRef text, std::size_t offset, SourceLocation location) {
    std::size_t const begin = text.rfind('#', offset + 1);
    std::size_t end = begin;
    do end = std::min(text.find('\n', end + 1), text.size());
    while (end < text.size() && text[end - 1] == '\\');
    llvm::StringRef const line = text.slice(begin, end);
    std::string words;
    for (llvm::StringRef rest = line.drop_front(); !rest.empty(); rest = rest.drop_front()) {
      if (rest.starts_with("//") || rest.starts_with("/*")) break;
      if (!rest.starts_with("\\\n")) words += rest.front();
    }
    note_pragma(words, begin, offset, line.size(), location);
  }

  // _Pragma("words"); where a macro makes the string of its argument, the macro's call
  void operation(llvm::StringRef text, std::size_t offset, SourceLocation location) {
    std::size_t const open = text.find('(', offset);
    std::size_t const begin = text.find_first_not_of(" \t", open + 1);
    if (begin == text.npos) return;
    if (text[begin] != '"') return call(location);
    std::size_t end = begin;
    while (end < text.size() && (end == begin || text[end - 1] == '\\')) end = text.find('"', end + 1);
    std::size_t const close = text.find(')', end);
    if (close == text.npos) return;
    std::string words = "pragma ";
    for (char const letter : text.slice(begin + 1, end))
      if (letter != '\\') words += letter;
    note_pragma(words, offset, offset, close + 1 - offset, location);
  }

  void call(SourceLocation location) {
    SourceLocation const begin = map_.sources().getExpansionLoc(location);
    std::optional<Span> const span = map_.range(map_.sources().getExpansionRange(location).getAsRange());
    if (!span || !location.isMacroID()) return;
    std::string const text = map_.text(*span, begin);
    llvm::StringRef const argument = llvm::StringRef(text).split('(').second.rsplit(')').first;
    std::string const words = normalised(argument.str());
    if (!map_.is_argument_of(begin, "REAL_EITHER") && instead_of(words))
      note(facts_, span, {text, "", 0}, map_.place(location), "#pragma " + words);
  }

  void note_pragma(std::string const &words, std::size_t begin, std::size_t offset, std::size_t length,
                   SourceLocation location) {
    std::string const text = normalised(words);
    llvm::StringRef pragma = text;
    if (!pragma.consume_front("pragma ")) return;
    if (pragma == "GCC push_options") in_force_.emplace_back();
    if (pragma == "GCC pop_options" && in_force_.size() > 1) in_force_.pop_back();
    std::optional<std::string> instead = instead_of(pragma);
    if (!instead) return;
    if (!map_.in_roots(location)) {
      if (pragma.starts_with("GCC ")) in_force_.back() = {map_.place(location), "#pragma " + pragma.str()};
      return;
    }
    std::optional<Span> span = map_.first_character(location);
    if (span) {
      span->begin = span->begin + begin - offset;
      span->end = span->begin + length;
    }
    auto const continued = static_cast<std::size_t>(std::count(words.begin(), words.end(), '\n'));
    note(facts_, span, {"_Pragma(" + in_quotes(pragma.str()) + ")", std::move(*instead), continued},
         map_.place(location), "#pragma " + pragma.str());
  }

  SourceMap const &map_;
  Facts &facts_;
  // Options of gcc that a header elsewhere sets for all that follows, until it restores those before.
  std::vector<std::optional<Outside>> in_force_{1};
};

class RoundingPragmas : public PPCallbacks {
public:
  RoundingPragmas(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}

  // Whether the compiler knows the pragma or not, its text suffices here.
  void PragmaDirective(SourceLocation location, PragmaIntroducerKind) override {
    if (!map_.in_roots(location)) return;
    llvm::StringRef const rest = map_.sources().getCharacterData(map_.sources().getSpellingLoc(location));
    llvm::StringRef const line = rest.take_until([](char c) { return c == '\n'; });
    auto const [before, mode] = line.split("FENV_ROUND");
    if (mode.empty() || !before.contains("STDC")) return;
    llvm::StringRef const name = mode.ltrim().take_while([](char c) { return llvm::isAlnum(c) || c == '_'; });
    if (name == "FE_TONEAREST" || name == "FE_DYNAMIC") return;
    add_diagnostic(facts_, {DiagnosticId::arithmetic_modes, map_.place(location),
                            "FENV_ROUND " + name.str() + ": what is computed here does not round to nearest"});
  }

private:
  SourceMap const &map_;
  Facts &facts_;
};

} // namespace

std::unique_ptr<PPCallbacks> make_arithmetic_pragma_watch(SourceMap const &map, Facts &facts) {
  return std::make_unique<ArithmeticPragmas>(map, facts);
}

std::unique_ptr<PPCallbacks> make_rounding_pragma_watch(SourceMap const &map, Facts &facts) {
  return std::make_unique<RoundingPragmas>(map, facts);
}

// __attribute__((...)), [[...]]
void ArithmeticAttributes::token(Token const &token) {
  tok::TokenKind const kind = token.getKind(), before = std::exchange(before_, kind);
  if (depth_ != 0) return within(token);
  bool const begins = (kind == tok::l_paren && is_announced_) || (kind == tok::l_square && before == tok::l_square);
  if (begins) depth_ = 1;
  is_announced_ = kind == tok::kw___attribute || name_of(token).starts_with("__attribute");
}

void ArithmeticAttributes::within(Token const &token) {
  if (token.isOneOf(tok::l_paren, tok::l_square))
    ++depth_;
  else if (token.isOneOf(tok::r_paren, tok::r_square))
    --depth_;
  if (depth_ < options_depth_) options_depth_ = 0;
  if (llvm::StringRef const name = name_of(token); !name.empty()) {
    is_target_ = name == "target" || name == "__target__";
    if (is_target_ || name == "optimize" || name == "__optimize__") options_depth_ = depth_ + 1;
  } else if (token.is(tok::string_literal) && options_depth_ != 0 && depth_ == options_depth_) {
    option(token);
  }
}

void ArithmeticAttributes::option(Token const &token) {
  SourceLocation const location = token.getLocation();
  if (!map_.in_roots(location)) return;
  if (map_.text_before(location).ends_with("REAL_EITHER((")) return;
  std::string const literal(token.getLiteralData(), token.getLength());
  if (std::optional<std::string> rest = without_them(literal, is_target_ ? "sse2" : "no-fast-math"))
    note(facts_, map_.token(location), {literal, std::move(*rest)}, map_.place(location),
         (is_target_ ? "target(" : "optimize(") + literal + ")");
}

} // namespace symreal::rewrite
