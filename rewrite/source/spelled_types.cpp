#include "rewrite/source/spelled_types.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Scanner {
public:
  Scanner(std::string const &path, LangOptions const &language, FileFact &file)
      : path_(path),
        file_(file),
        text_(file.text),
        lexer_(SourceLocation(), language, text_.data(), text_.data(), text_.data() + text_.size()) {
    lexer_.SetCommentRetentionState(true);
  }

  void run() {
    for (bool more = true; more;) {
      Token token;
      more = !lexer_.LexFromRawLexer(token) && token.isNot(tok::eof);
      if (token.is(tok::eof)) break;
      end_ = static_cast<std::size_t>(lexer_.getBufferLocation() - text_.data());
      begin_ = end_ - token.getLength();
      starts_line_ = starts_line_ || token.isAtStartOfLine();
      if (token.is(tok::comment)) {
        if (spelling().find("symreal: keep") != std::string::npos) keep_line();
        continue;
      }
      if (starts_line_) end_directive(begin_);
      if (starts_line_ && token.is(tok::hash))
        begin_directive();
      else if (token.is(tok::raw_identifier))
        word(cleaned());
      else
        before_ = {};
      starts_line_ = false;
    }
    end_directive(text_.size());
    mark_kept();
  }

private:
  std::string spelling() const { return text_.substr(begin_, end_ - begin_); }
  // The word without line continuations.
  std::string cleaned() const {
    std::string word;
    for (char c : spelling())
      if (c != '\\' && c != '\n' && c != '\r') word += c;
    return word;
  }

  void begin_directive() {
    in_directive_ = true;
    directive_begin_ = begin_;
    directive_.clear();
    before_ = {};
  }

  void end_directive(std::size_t end) {
    if (in_directive_) file_.directives.push_back({directive_begin_, end});
    in_directive_ = false;
  }

  void word(std::string const &word) {
    if (in_directive_ && directive_.empty()) {
      directive_ = word;
      name_ = "#" + word;
      open_condition();
    } else if (in_directive_ && directive_ == "define" && name_ == "#define")
      name_ = word;
    if (in_directive_ && llvm::StringRef(directive_).starts_with("include")) return; // the name of a file
    if (word == "double" || word == "float") {
      SpelledType found{{path_, begin_, end_}};
      found.is_float = word == "float";
      found.is_long = before_ == "long";
      found.within = within_;
      // A macro's body follows its name; the name itself does not spell a type.
      bool const is_body = directive_ == "define" && name_ != word;
      if (in_directive_) found.where = is_body ? SpelledType::Where::macro : SpelledType::Where::directive;
      if (in_directive_) found.name = is_body ? name_ : "#" + directive_;
      file_.spelled.push_back(std::move(found));
    }
    // `long double` may be written the other way round, with qualifiers between.
    if (word == "long" && before_ == "double" && !file_.spelled.empty()) file_.spelled.back().is_long = true;
    if (word != "const" && word != "volatile") before_ = word;
  }

  std::string directive_text() const {
    std::size_t const line_end = std::min(text_.find('\n', directive_begin_), text_.size());
    std::string text;
    for (char c : text_.substr(directive_begin_, line_end - directive_begin_))
      if (!isspace(static_cast<unsigned char>(c)))
        text += c;
      else if (!text.empty() && text.back() != ' ' && text.back() != '#')
        text += ' ';
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
  }

  void open_condition() {
    llvm::StringRef const kind = directive_;
    if (kind.starts_with("if")) {
      open_.push_back(directive_text());
      within_.push_back(directive_begin_);
      file_.conditions[directive_begin_] = open_.back();
    } else if (open_.empty())
      return;
    else if (kind.starts_with("el")) {
      within_.back() = directive_begin_;
      file_.conditions[directive_begin_] = kind == "else" ? "#else of " + open_.back() : directive_text();
    } else if (kind == "endif") {
      open_.pop_back();
      within_.pop_back();
    }
  }

  void keep_line() {
    std::size_t const before = begin_ == 0 ? std::string::npos : text_.rfind('\n', begin_ - 1);
    file_.kept.push_back(
        {before == std::string::npos ? 0 : before + 1, std::min(text_.find('\n', begin_), text_.size())});
  }

  void mark_kept() {
    for (SpelledType &type : file_.spelled)
      for (auto const &[begin, end] : file_.kept)
        type.kept = type.kept || (type.span.begin >= begin && type.span.end <= end);
  }

  std::string const &path_;
  FileFact &file_;
  std::string const &text_;
  Lexer lexer_;
  std::size_t begin_ = 0, end_ = 0; // of the token
  bool starts_line_ = true, in_directive_ = false;
  std::size_t directive_begin_ = 0;
  std::string directive_, name_, before_;
  std::vector<std::string> open_;   // each #if
  std::vector<std::size_t> within_; // the part of it
};

class SkippedText : public PPCallbacks {
public:
  SkippedText(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}

  void SourceRangeSkipped(SourceRange range, SourceLocation) override {
    if (std::optional<Span> const span = map_.characters(range.getBegin(), range.getEnd()))
      facts_.skipped.insert(*span);
  }

  void MacroExpands(Token const &name, MacroDefinition const &definition, SourceRange,
                    MacroArgs const *arguments) override {
    note(name, macro_name);
    MacroInfo const *macro = definition.getMacroInfo();
    if (!arguments || !macro) return;
    for (unsigned i = 0; i < macro->getNumParams(); ++i)
      for (Token const *token = arguments->getUnexpArgument(i); token->isNot(tok::eof); ++token)
        note(*token, dropped_argument);
  }

private:
  void note(Token const &token, Passive how) {
    IdentifierInfo const *word = token.getIdentifierInfo();
    if (!word || !word->isStr("double")) return;
    if (std::optional<Span> const span = map_.token(token.getLocation()))
      symreal::rewrite::note(facts_.types, *span, {Fate::inactive, "", how});
  }

  SourceMap const &map_;
  Facts &facts_;
};

} // namespace

void find_spelled_types(std::string const &path, LangOptions const &language, FileFact &file) {
  Scanner(path, language, file).run();
}

std::unique_ptr<PPCallbacks> make_skipped_text_collector(SourceMap const &map, Facts &facts) {
  return std::make_unique<SkippedText>(map, facts);
}

} // namespace symreal::rewrite
