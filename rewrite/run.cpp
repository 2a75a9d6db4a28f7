#include "rewrite/clang.h"
#include "rewrite/decide.h"
#include "rewrite/pragma_handler.h"
#include "rewrite/quoted_arguments.h"
#include "rewrite/rewrite.h"
#include "rewrite/source_map.h"
#include "rewrite/visitor.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

// An error of the compiler, which becomes a diagnostic of ours when the whole source has been read.
struct CompilerError {
  unsigned id;
  std::string message;
  Place place;
  std::optional<Span> token;
};

class ErrorCollector : public DiagnosticConsumer {
public:
  ErrorCollector(std::vector<std::string> const &roots, std::vector<CompilerError> &errors)
      : roots_(roots), errors_(errors) {}

  void BeginSourceFile(LangOptions const &language, Preprocessor const *) override { language_ = language; }
  void HandleDiagnostic(DiagnosticsEngine::Level level, clang::Diagnostic const &info) override {
    DiagnosticConsumer::HandleDiagnostic(level, info);
    if (level < DiagnosticsEngine::Error) return;
    llvm::SmallString<256> message;
    info.FormatDiagnostic(message);
    // Options that only the user's own compiler knows say nothing about the source.
    if (!info.getLocation().isValid() && message.str().contains("unknown argument")) return;
    CompilerError error{info.getID(), message.str().str(), {}, {}};
    if (info.hasSourceManager() && info.getLocation().isValid()) {
      SourceMap const map(info.getSourceManager(), language_, roots_);
      error.place = map.place(info.getLocation());
      error.token = map.token(info.getLocation());
    }
    errors_.push_back(std::move(error));
  }

private:
  std::vector<std::string> const &roots_;
  std::vector<CompilerError> &errors_;
  LangOptions language_;
};

class Consumer : public ASTConsumer {
public:
  Consumer(CompilerInstance &compiler, std::vector<std::string> const &roots, Facts &facts)
      : compiler_(compiler), map_(compiler.getSourceManager(), compiler.getLangOpts(), roots), facts_(facts) {
    Preprocessor &preprocessor = compiler.getPreprocessor();
    preprocessor.AddPragmaHandler(make_pragma_handler(map_, facts_, index_).release()); // owned there from now on
    preprocessor.addPPCallbacks(make_quoted_argument_recorder(map_, facts_));
  }

  void HandleTranslationUnit(ASTContext &context) override {
    map_.record_files(facts_);
    if (compiler_.getDiagnostics().hasErrorOccurred()) return;
    record_tree(context, map_, index_, facts_);
    record_include_directories();
  }

private:
  void record_include_directories() {
    HeaderSearch const &search = compiler_.getPreprocessor().getHeaderSearchInfo();
    for (auto at = search.search_dir_begin(); at != search.search_dir_end(); ++at) {
      if (!at->isNormalDir()) continue;
      std::string const name = at->getName().str();
      std::vector<std::string> &known = facts_.include_dirs;
      if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    }
  }

  CompilerInstance &compiler_;
  SourceMap map_;
  PragmaIndex index_;
  Facts &facts_;
};

class Action : public ASTFrontendAction {
public:
  Action(std::vector<std::string> const &roots, Facts &facts) : roots_(roots), facts_(facts) {}
  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
    return std::make_unique<Consumer>(compiler, roots_, facts_);
  }

private:
  std::vector<std::string> const &roots_;
  Facts &facts_;
};

// The compiler's command line without what only concerns its outputs.
std::vector<std::string> command_line(Request const &request, std::string const &source) {
  std::vector<std::string> words = {"clang", "-fsyntax-only", "-w", "-Wno-error", "-Qunused-arguments", "-fno-caret-diagnostics",
                                    "-resource-dir=" SYMREAL_CLANG_RESOURCES, "-ferror-limit=20"};
  for (std::size_t i = 0; i < request.flags.size(); ++i) {
    std::string const &flag = request.flags[i];
    if (flag == "-o" || flag == "-MF" || flag == "-MT" || flag == "-MQ") ++i;
    else if (flag != "-c" && flag != "-S" && flag != "-E" && flag != "-Werror" && flag.rfind("-M", 0) != 0) words.push_back(flag);
  }
  words.push_back(source);
  return words;
}

// An error at a token of a pragma is about the pragma; what follows from it in the rest of the source is not told.
void report_errors(std::vector<CompilerError> const &errors, Facts &facts) {
  auto const pragma_of = [&](CompilerError const &error) -> PragmaFact const * {
    if (!error.token) return nullptr;
    for (auto const &[span, pragma] : facts.pragmas)
      if (span.file == error.token->file && span.begin <= error.token->begin && error.token->begin < span.end)
        return &pragma;
    return nullptr;
  };
  bool in_pragma = false;
  for (CompilerError const &error : errors) {
    if (!pragma_of(error)) continue;
    bool const undeclared = error.message.find("undeclared") != std::string::npos;
    bool const expression = error.id != diag::err_undeclared_var_use && !undeclared &&
                            error.message.rfind("expected", 0) != 0;
    DiagnosticId const id = undeclared   ? DiagnosticId::pragma_undeclared_name
                            : expression ? DiagnosticId::pragma_item
                                         : DiagnosticId::pragma_position;
    std::string const message = undeclared || expression ? error.message
                                                         : "no statement can stand where this pragma stands";
    Place const place = undeclared || expression ? error.place : pragma_of(error)->place;
    bool const told = std::any_of(facts.diagnostics.begin(), facts.diagnostics.end(), [&](auto const &known) {
      return known.id == id && to_string(known.place) == to_string(place);
    });
    if (!told) facts.diagnostics.push_back({id, Severity::error, place, message});
    in_pragma = true;
  }
  if (!in_pragma)
    for (CompilerError const &error : errors)
      facts.diagnostics.push_back({DiagnosticId::source_error, Severity::error, error.place, error.message});
}

void record_source(Request const &request, std::vector<std::string> const &roots, std::string const &source,
                   Facts &facts) {
  if (!llvm::sys::fs::exists(source)) fail(DiagnosticId::unreadable_file, {source}, "the file cannot be read");
  std::vector<CompilerError> errors;
  ErrorCollector collector(roots, errors);
  IntrusiveRefCntPtr<FileManager> const files(new FileManager(FileSystemOptions()));
  tooling::ToolInvocation invocation(command_line(request, source), std::make_unique<Action>(roots, facts), files.get());
  invocation.setDiagnosticConsumer(&collector);
  bool const ran = invocation.run();
  report_errors(errors, facts);
  if (!errors.empty() || !ran) facts.broken = true;
  if (!ran && errors.empty())
    facts.diagnostics.push_back({DiagnosticId::source_error, Severity::error, {source}, "the source cannot be parsed"});
}

std::vector<std::string> real_roots(Request const &request) {
  std::vector<std::string> roots;
  for (std::string const &root : request.roots) roots.push_back(real_path(root));
  if (roots.empty())
    for (std::string const &source : request.sources)
      roots.push_back(llvm::sys::path::parent_path(real_path(source)).str());
  return roots;
}

} // namespace

Result run(Request const &request) {
  std::vector<std::string> const roots = real_roots(request);
  Facts facts;
  for (std::string const &source : request.sources) record_source(request, roots, source, facts);
  return decide(std::move(facts));
}

} // namespace symreal::rewrite
