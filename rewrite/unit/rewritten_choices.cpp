#include "rewrite/unit/rewritten_choices.h"

#include "rewrite/collect/choices.h"
#include "rewrite/facts/merge.h"
#include "rewrite/unit/collect_source.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Consumer : public ASTConsumer {
public:
  Consumer(CompilerInstance &compiler, Scope const &scope, bool of_rewritten, Choices &choices)
      : compiler_(compiler),
        map_(compiler.getSourceManager(), compiler.getLangOpts(), scope),
        of_rewritten_(of_rewritten),
        choices_(choices) {}
  void HandleTranslationUnit(ASTContext &context) override {
    if (!compiler_.getDiagnostics().hasErrorOccurred()) collect_choices(context, map_, of_rewritten_, choices_);
  }

private:
  CompilerInstance &compiler_;
  SourceMap map_;
  bool const of_rewritten_;
  Choices &choices_;
};

class Action : public ASTFrontendAction {
public:
  Action(Scope const &scope, bool of_rewritten, Choices &choices)
      : scope_(scope),
        of_rewritten_(of_rewritten),
        choices_(choices) {}
  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
    return std::make_unique<Consumer>(compiler, scope_, of_rewritten_, choices_);
  }

private:
  Scope const &scope_;
  bool const of_rewritten_;
  Choices &choices_;
};

// Earlier ones are compiled as C++20, which the runtime needs.
bool is_new_enough(std::vector<std::string> const &flags) {
  return std::any_of(flags.begin(), flags.end(), [](llvm::StringRef flag) {
    return flag.starts_with("-std=") &&
           (flag.ends_with("20") || flag.ends_with("2a") || flag.ends_with("23") || flag.ends_with("2b"));
  });
}

Choices read(Compilation const &source, Request const &request, Scope const &scope, bool of_rewritten) {
  Choices choices;
  FileSystem const files = file_system(source, request, own_disk());
  IntrusiveRefCntPtr<FileManager> const manager(new FileManager(FileSystemOptions(), files));
  tooling::ToolInvocation invocation(command_line(source), std::make_unique<Action>(scope, of_rewritten, choices),
                                     manager.get());
  IgnoringDiagConsumer ignoring;
  invocation.setDiagnosticConsumer(&ignoring);
  invocation.run();
  return choices;
}

Compilation symbolic(Compilation source, std::string const &type_name) {
  for (std::string const &flag : type_name_flags(type_name)) source.flags.push_back(flag);
  source.flags.emplace_back("-DMBD_SYMBOLIC");
  if (!is_new_enough(source.flags))
    source.flags.insert(source.flags.end(), {"-std=gnu++20", "-fno-char8_t", "-DSYMREAL_BEFORE_CXX20"});
  return source;
}

// Does the text have words with which a program asks about types? Most have none, and are not read again.
bool may_ask(std::string const &text) {
  if (text.find("template") == text.npos && text.find("auto") == text.npos) return false;
  constexpr llvm::StringLiteral words[] = {"::*",     "__is_",     "__has_",       "::is_",  "requires",
                                           "concept", "enable_if", "if constexpr", "void_t", "(...)"};
  return llvm::any_of(words, [&](llvm::StringRef word) { return llvm::StringRef(text).contains(word); });
}

std::string list_of(std::set<std::string> const &results) {
  std::string text;
  for (std::string const &result : results) text += (text.empty() ? "" : ", ") + result;
  return text;
}

} // namespace

void compare_choices(std::vector<Compilation> const &sources, Scope const &scope, Request const &request,
                     Result &result) {
  if (llvm::none_of(result.files, [](File const &file) { return may_ask(file.original); })) return;
  Request rewritten = request;
  rewritten.texts.clear();
  for (File const &file : result.files) rewritten.texts.push_back({file.path, file.text});
  std::vector<std::pair<Choices, Choices>> read_of(sources.size());
  Progress progress("sources read again", sources.size());
  in_parallel(sources.size(), request.jobs, [&](std::size_t k) {
    auto &[original, symbolic_ones] = read_of[k];
    original = read(sources[k], request, scope, /*of_rewritten=*/false);
    if (!original.empty())
      symbolic_ones = read(symbolic(sources[k], result.type_name), rewritten, scope, /*of_rewritten=*/true);
    progress.add();
  });
  std::set<std::string> known;
  for (auto const &[original, symbolic_ones] : read_of) {
    for (auto const &[key, choice] : symbolic_ones) {
      auto const found = original.find(key);
      if (found == original.end()) continue; // what leads there is another choice
      Choice const &before = found->second;
      if (before.results == choice.results || !known.insert(key).second) continue;
      result.diagnostics.push_back({DiagnosticId::rewriting_mismatch, before.place,
                                    choice.what + " is " + list_of(choice.results) + " in the symbolic program, and " +
                                        list_of(before.results) + " in the original"});
    }
  }
}

} // namespace symreal::rewrite
