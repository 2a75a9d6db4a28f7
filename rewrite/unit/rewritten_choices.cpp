#include "rewrite/unit/rewritten_choices.h"

#include "engine/support/parallel.h"
#include "engine/support/progress.h"
#include "rewrite/collect/choices.h"
#include "rewrite/facts/merge.h"
#include "rewrite/unit/collect_source.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Consumer : public ASTConsumer {
public:
  Consumer(CompilerInstance &compiler, Scope const &scope, Choices &choices)
      : compiler_(compiler),
        map_(compiler.getSourceManager(), compiler.getLangOpts(), scope),
        choices_(choices) {}
  void HandleTranslationUnit(ASTContext &context) override {
    if (!compiler_.getDiagnostics().hasErrorOccurred()) choices_ = collect_choices(context, map_).choices;
  }

private:
  CompilerInstance &compiler_;
  SourceMap map_;
  Choices &choices_;
};

class Action : public ASTFrontendAction {
public:
  Action(Scope const &scope, Choices &choices) : scope_(scope), choices_(choices) {}
  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
    return std::make_unique<Consumer>(compiler, scope_, choices_);
  }

private:
  Scope const &scope_;
  Choices &choices_;
};

// Earlier ones are compiled as C++20, which the runtime needs.
bool is_new_enough(std::vector<std::string> const &flags) {
  return std::any_of(flags.begin(), flags.end(), [](llvm::StringRef flag) {
    return flag.starts_with("-std=") &&
           (flag.ends_with("20") || flag.ends_with("2a") || flag.ends_with("23") || flag.ends_with("2b"));
  });
}

Choices read(Compilation const &source, Request const &request, Scope const &scope) {
  Choices choices;
  FileSystem const files = file_system(source, request, own_disk());
  IntrusiveRefCntPtr<FileManager> const manager(new FileManager(FileSystemOptions(), files));
  tooling::ToolInvocation invocation(command_line(source), std::make_unique<Action>(scope, choices), manager.get());
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

std::string list_of(std::set<std::string> const &results) {
  std::string text;
  for (std::string const &result : results) text += (text.empty() ? "" : ", ") + result;
  return text;
}

} // namespace

void compare_choices(Choices const &original, std::vector<Compilation> const &asking, Scope const &scope,
                     Request const &request, Result &result) {
  if (asking.empty()) return; // the copies of all texts are not needed
  Request rewritten = request;
  rewritten.texts.clear();
  for (File const &file : result.files) rewritten.texts.push_back({file.path, file.text});
  std::vector<Choices> read_of(asking.size());
  Progress progress("rewritten sources", asking.size());
  in_parallel(asking.size(), request.jobs, [&](std::size_t k) {
    read_of[k] = read(symbolic(asking[k], result.type_name), rewritten, scope);
    progress.add();
  });
  Choices rewritten_ones;
  for (Choices &one : read_of) merge(rewritten_ones, std::move(one));
  std::set<std::string> told; // places
  for (auto const &[key, choice] : rewritten_ones) {
    auto const found = original.find(key);
    if (found == original.end()) continue; // an earlier choice leads there
    Choice const &before = found->second;
    if (before.results == choice.results || !told.insert(to_string(before.place)).second) continue;
    result.diagnostics.push_back({DiagnosticId::rewriting_mismatch, before.place,
                                  choice.what + " is " + list_of(choice.results) + " in the symbolic program, and " +
                                      list_of(before.results) + " in the original"});
  }
}

} // namespace symreal::rewrite
