#include "rewrite/unit/collect_source.h"

#include "engine/support/installation.h"
#include "rewrite/pragma/configured.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/request/driver_options.h"
#include "rewrite/source/arithmetic.h"
#include "rewrite/source/expansion_text.h"
#include "rewrite/source/source_map.h"
#include "rewrite/source/spelled_types.h"
#include "rewrite/source/token_watch.h"
#include "rewrite/unit/choices.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

// An error of the compiler, which becomes a diagnostic of ours when the whole source has been read.
struct CompilerError {
  std::string message;
  Place place;
  std::optional<Span> token;
  std::vector<Note> notes;             // enclosing macros and instantiations, further notes of the compiler
  unsigned id = 0;                     // Clang's
  std::vector<std::string> names = {}; // and options that it is about
};

// The arguments of Clang's message that are words of the source or of the command line.
std::vector<std::string> names_in(clang::Diagnostic const &info) {
  std::vector<std::string> names;
  for (unsigned i = 0; i < info.getNumArgs(); ++i) switch (info.getArgKind(i)) {
    case DiagnosticsEngine::ak_std_string: names.push_back(info.getArgStdStr(i)); break;
    case DiagnosticsEngine::ak_c_string: names.emplace_back(info.getArgCStr(i)); break;
    case DiagnosticsEngine::ak_identifierinfo: names.push_back(info.getArgIdentifier(i)->getName().str()); break;
    case DiagnosticsEngine::ak_declarationname:
      names.push_back(DeclarationName::getFromOpaqueInteger(info.getRawArg(i)).getAsString());
      break;
    case DiagnosticsEngine::ak_nameddecl:
      names.push_back(reinterpret_cast<NamedDecl const *>(info.getRawArg(i))->getNameAsString());
      break;
    default: break;
    }
  return names;
}

bool is_undeclared(unsigned id) {
  return id == diag::err_undeclared_var_use || id == diag::err_undeclared_var_use_suggest ||
         id == diag::err_undeclared_use || id == diag::err_undeclared_use_suggest;
}

bool is_of_parser(unsigned id) {
  return DiagnosticIDs::getCategoryNameFromID(DiagnosticIDs::getCategoryNumberForDiag(id)) == "Parse Issue";
}

class ErrorCollector : public DiagnosticConsumer {
public:
  ErrorCollector(Scope const &scope, std::vector<CompilerError> &errors) : scope_(scope), errors_(errors) {}

  void BeginSourceFile(LangOptions const &language, Preprocessor const *) override { language_ = language; }
  void HandleDiagnostic(DiagnosticsEngine::Level level, clang::Diagnostic const &info) override {
    DiagnosticConsumer::HandleDiagnostic(level, info);
    if (level == DiagnosticsEngine::Note && follows_error_) return note(info);
    follows_error_ = level >= DiagnosticsEngine::Error;
    if (!follows_error_) return;
    CompilerError error{text(info), {}, {}, {}, info.getID(), names_in(info)};
    if (info.hasSourceManager() && info.getLocation().isValid()) {
      SourceMap const map(info.getSourceManager(), language_, scope_);
      error.place = map.place(info.getLocation());
      error.token = map.token(info.getLocation());
      error.notes = map.expansions(info.getLocation());
    }
    errors_.push_back(std::move(error));
  }

private:
  static std::string text(clang::Diagnostic const &info) {
    llvm::SmallString<256> message;
    info.FormatDiagnostic(message);
    return message.str().str();
  }

  void note(clang::Diagnostic const &info) {
    constexpr std::size_t most = 5;
    std::vector<Note> &notes = errors_.back().notes;
    if (notes.size() >= most || !info.hasSourceManager() || info.getLocation().isInvalid()) return;
    notes.push_back({SourceMap(info.getSourceManager(), language_, scope_).place(info.getLocation()), text(info)});
  }

  bool follows_error_ = false;
  Scope const &scope_;
  std::vector<CompilerError> &errors_;
  LangOptions language_;
};

// Settings shared by all readings of one source.
struct Settings {
  Scope const &scope;
  Request const &request;
  bool ask_compiler;     // about the items of pragmas
  std::string type_name; // must be unused in the sources, if set
  std::string source;    // its real path
};

class Consumer : public ASTConsumer {
public:
  Consumer(CompilerInstance &compiler, Settings const &settings, Facts &facts)
      : compiler_(compiler),
        map_(compiler.getSourceManager(), compiler.getLangOpts(), settings.scope),
        settings_(settings),
        facts_(facts) {
    index_.ask_compiler = settings.ask_compiler;
    Preprocessor &preprocessor = compiler.getPreprocessor();
    preprocessor.AddPragmaHandler(make_pragma_handler(map_, facts_, index_).release()); // owned there from now on
    preprocessor.addPPCallbacks(make_quoted_argument_collector(map_, facts_, expansions_));
    preprocessor.addPPCallbacks(make_skipped_text_collector(map_, facts_));
    preprocessor.addPPCallbacks(make_rounding_pragma_watch(map_, facts_));
    watch_tokens(preprocessor, map_, settings.type_name, facts_, expansions_);
  }

  void HandleTranslationUnit(ASTContext &context) override {
    map_.collect_files(facts_);
    if (compiler_.getDiagnostics().hasErrorOccurred()) return;
    index_configured_externals(settings_.request, context, index_, facts_);
    collect_tree(context, map_, index_, settings_.request, facts_);
    expansions_.collect(facts_);
    collect_include_directories();
    if (CollectedChoices found = collect_choices(context, map_); found.asks) {
      facts_.choices = std::move(found.choices);
      facts_.asking.insert(settings_.source);
    }
  }

private:
  void collect_include_directories() {
    HeaderSearch const &search = compiler_.getPreprocessor().getHeaderSearchInfo();
    for (auto at = search.search_dir_begin(); at != search.search_dir_end(); ++at) {
      if (!at->isNormalDir()) continue;
      llvm::SmallString<256> absolute(at->getName());
      if (compiler_.getFileManager().getVirtualFileSystem().makeAbsolute(absolute))
        continue; // the directory does not exist
      std::string const name = absolute.str().str();
      std::vector<std::string> &known = facts_.include_dirs;
      if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    }
  }

  CompilerInstance &compiler_;
  SourceMap map_;
  ExpansionText expansions_{map_};
  Settings const &settings_;
  PragmaIndex index_;
  Facts &facts_;
};

class Action : public ASTFrontendAction {
public:
  Action(Settings const &settings, Facts &facts) : settings_(settings), facts_(facts) {}
  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
    return std::make_unique<Consumer>(compiler, settings_, facts_);
  }

private:
  Settings const &settings_;
  Facts &facts_;
};

// A kernel is recorded by one thread, and the symbolic program is compiled without OpenMP: so it is read without it,
// and _OPENMP is defined in neither. <omp.h>, which a source may include all the same, lies among the compiler's own
// headers.
void read_serially(std::vector<std::string> &words) {
  std::vector<std::string> serial = without(words, {About::openmp});
  if (serial.size() == words.size()) return;
  words = std::move(serial);
  std::error_code error;
  for (llvm::sys::fs::recursive_directory_iterator at("/usr/lib/gcc", error), end; at != end && !error;
       at.increment(error)) {
    if (at.level() > 3) at.no_push();
    if (llvm::sys::path::filename(at->path()) != "omp.h") continue;
    words.insert(words.end(), {"-idirafter", llvm::sys::path::parent_path(at->path()).str()});
    words.emplace_back("-D__malloc__(...)="); // an attribute of gcc's alone
    return;
  }
}

// The compiler's command line without options that only concern its outputs.
std::vector<std::string> command_line(Compilation const &compilation) {
  std::string const resources = "-resource-dir=" SYMREAL_CLANG_RESOURCES;
  std::vector<std::string> words = {
      "clang",           "-fsyntax-only",   "-Qunused-arguments",           "-fno-caret-diagnostics",
      resources,         "-isystem",        runtime_include() + "/reading", "-isystem",
      runtime_include(), "-ferror-limit=20"};
  for (std::string const &flag :
       without(compilation.flags, {About::output, About::action, About::dependencies, About::question}))
    words.push_back(flag);
  words.insert(words.end(), compilation.defines.begin(), compilation.defines.end());
  read_serially(words);
  words.emplace_back("-Wno-everything"); // some are errors to Clang alone: -Wimplicit-int, -Wenum-constexpr-conversion
  words.push_back("--");
  words.push_back(compilation.source);
  return words;
}

void add(Facts &facts, DiagnosticId id, Place const &place, std::string message, std::vector<Note> notes = {}) {
  for (symreal::Diagnostic const &known : facts.diagnostics)
    if (known.id == id && to_string(known.place) == to_string(place)) return;
  facts.diagnostics.push_back({id, place, std::move(message), std::move(notes)});
}

// The errors that stand at a token of a pragma.
void report_pragma_errors(std::vector<CompilerError> const &errors, Facts &facts) {
  for (CompilerError const &error : errors) {
    if (!error.token) continue;
    for (auto const &[span, pragma] : facts.pragmas) {
      if (span.file != error.token->file || error.token->begin < span.begin || span.end <= error.token->begin) continue;
      if (is_undeclared(error.id))
        add(facts, DiagnosticId::pragma_undeclared_name, error.place, error.message);
      else if (is_of_parser(error.id))
        add(facts, DiagnosticId::pragma_position, pragma.place, "this pragma stands where no statement can stand");
      else
        add(facts, DiagnosticId::pragma_item, error.place, error.message);
    }
  }
}

// Removes options that Clang rejects, or their values: those that only the user's own compiler knows do not affect the
// source. Returns whether there was one.
bool leave_out_options(std::vector<CompilerError> const &errors, std::vector<std::string> &flags) {
  std::size_t const before = flags.size();
  for (CompilerError const &error : errors) {
    if (error.place.line != 0) continue;
    for (llvm::StringRef name : error.names)
      std::erase_if(flags, [name](llvm::StringRef flag) {
        bool const is_value = flag.starts_with("-") && flag.split('=').second == name && !name.empty();
        return is_value || (name.starts_with("-") && (flag == name || (name.ends_with("=") && flag.starts_with(name))));
      });
  }
  return flags.size() != before;
}

// Disables builtins that a variable redefines: the compiler knows such functions without a header. Returns whether
// there was one.
bool forget_builtins(std::vector<CompilerError> const &errors, std::vector<std::string> &flags) {
  std::size_t const before = flags.size();
  for (CompilerError const &error : errors) {
    if (error.id != diag::err_redefinition_different_kind || error.names.empty()) continue;
    std::string const flag = "-fno-builtin-" + error.names.front();
    if (std::find(flags.begin(), flags.end(), flag) == flags.end()) flags.push_back(flag);
  }
  return flags.size() != before;
}

struct Parsed {
  Facts facts;
  std::vector<CompilerError> errors;
};

Parsed parse(Compilation compilation, FileSystem const &disk, Settings const &settings) {
  while (true) {
    Parsed parsed;
    ErrorCollector collector(settings.scope, parsed.errors);
    IntrusiveRefCntPtr<FileManager> const files(new FileManager(FileSystemOptions(), disk));
    tooling::ToolInvocation invocation(command_line(compilation), std::make_unique<Action>(settings, parsed.facts),
                                       files.get());
    invocation.setDiagnosticConsumer(&collector);
    bool const done = invocation.run();
    if (leave_out_options(parsed.errors, compilation.flags) || forget_builtins(parsed.errors, compilation.flags))
      continue;
    if (!done && parsed.errors.empty())
      parsed.errors.push_back({"the source cannot be parsed", {compilation.source}, {}, {}, 0, {}});
    return parsed;
  }
}

bool names_real(std::vector<CompilerError> const &errors, std::string const &type_name) {
  return std::any_of(errors.begin(), errors.end(), [&](CompilerError const &error) {
    return std::any_of(error.names.begin(), error.names.end(), [&](std::string const &name) {
      return name.starts_with("REAL") || name.starts_with("SYMREAL_") || (!type_name.empty() && name == type_name);
    });
  });
}

} // namespace

FileSystem file_system(Compilation const &compilation, Request const &request, FileSystem const &disk) {
  IntrusiveRefCntPtr<llvm::vfs::OverlayFileSystem> const files(new llvm::vfs::OverlayFileSystem(disk));
  IntrusiveRefCntPtr<llvm::vfs::InMemoryFileSystem> const texts(new llvm::vfs::InMemoryFileSystem);
  for (TextSource const &one : request.texts)
    texts->addFile(one.path, 0, llvm::MemoryBuffer::getMemBufferCopy(one.text));
  if (!request.texts.empty()) files->pushOverlay(texts);
  if (!compilation.directory.empty() && files->setCurrentWorkingDirectory(compilation.directory))
    fail(DiagnosticId::compile_commands, {}, "the directory '" + compilation.directory + "' does not exist");
  if (!files->exists(compilation.source))
    fail(DiagnosticId::unreadable_file, {}, "'" + compilation.source + "' cannot be read");
  return files;
}

void visit_tree(Compilation const &compilation, FileSystem const &files, Scope const &scope,
                std::function<void(ASTContext &, SourceMap const &)> const &visit) {
  using Visit = std::function<void(ASTContext &, SourceMap const &)>;
  class TreeConsumer : public ASTConsumer {
  public:
    TreeConsumer(CompilerInstance &compiler, Scope const &scope, Visit const &visit)
        : map_(compiler.getSourceManager(), compiler.getLangOpts(), scope),
          visit_(visit) {}
    void HandleTranslationUnit(ASTContext &context) override { visit_(context, map_); }

  private:
    SourceMap map_;
    Visit const &visit_;
  };
  class TreeAction : public ASTFrontendAction {
  public:
    TreeAction(Scope const &scope, Visit const &visit) : scope_(scope), visit_(visit) {}
    std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
      return std::make_unique<TreeConsumer>(compiler, scope_, visit_);
    }

  private:
    Scope const &scope_;
    Visit const &visit_;
  };
  IgnoringDiagConsumer ignored;
  IntrusiveRefCntPtr<FileManager> const manager(new FileManager(FileSystemOptions(), files));
  tooling::ToolInvocation invocation(command_line(compilation), std::make_unique<TreeAction>(scope, visit),
                                     manager.get());
  invocation.setDiagnosticConsumer(&ignored);
  invocation.run();
}

FileSystem own_disk() { return llvm::vfs::createPhysicalFileSystem().release(); }

Facts collect_source(Compilation const &compilation, Scope const &scope, Request const &request,
                     FileSystem const &disk) {
  FileSystem const files = file_system(compilation, request, disk);
  Settings settings{scope, request, true, request.type_name, real_source(compilation)};
  auto [facts, errors] = parse(compilation, files, settings);
  if (names_real(errors, request.type_name)) {
    // Already rewritten: it compiles as before with the header that defines REAL.
    settings.type_name.clear();
    for (std::string const &name : {std::string(usual_type_name), request.type_name, std::string(reserved_type_name)}) {
      if (name.empty()) continue;
      Compilation rewritten = compilation;
      for (std::string const &flag : type_name_flags(name)) rewritten.flags.push_back(flag);
      if (Parsed again = parse(rewritten, files, settings); again.errors.empty()) return std::move(again.facts);
    }
  }
  if (errors.empty()) return std::move(facts);
  facts.broken = true;
  // Errors without the pragmas' statements are the source's own.
  Settings const bare{scope, request, false, request.type_name, settings.source};
  std::vector<CompilerError> const own = facts.pragmas.empty() ? errors : parse(compilation, files, bare).errors;
  for (CompilerError const &error : own)
    add(facts, DiagnosticId::source_error, error.place, error.message, error.notes);
  if (own.empty()) report_pragma_errors(errors, facts);
  return std::move(facts);
}

} // namespace symreal::rewrite
