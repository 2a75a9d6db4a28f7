#include "rewrite/model/surroundings.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/walk.h"

#include <algorithm>

namespace symreal::rewrite {
using namespace clang;

namespace {

// A mention of a variable, in order to see whether it is assigned there.
struct Mention {
  std::size_t offset;
  Expr const *name;
};

class Mentions : public Walk {
public:
  explicit Mentions(SourceManager const &sources) : sources_(sources) {}

  bool VisitDeclRefExpr(DeclRefExpr *name) override {
    if (auto const *variable = dyn_cast<VarDecl>(name->getDecl()))
      found[variable].push_back({sources_.getFileOffset(sources_.getExpansionLoc(name->getLocation())), name});
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    if (binary->getOpcode() == BO_Assign) changes(binary->getLHS());
    return true;
  }
  bool VisitCXXOperatorCallExpr(CXXOperatorCallExpr *call) override {
    if (call->getOperator() == OO_Equal) changes(call->getArg(0));
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    if (unary->getOpcode() == UO_AddrOf) changes(unary->getSubExpr());
    return true;
  }
  std::map<VarDecl const *, std::vector<Mention>> found;
  llvm::SmallPtrSet<VarDecl const *, 8> changed; // they get another value as a whole, or their addresses are taken

private:
  void changes(Expr const *object) {
    if (auto const *name = dyn_cast<DeclRefExpr>(object->IgnoreParenImpCasts()))
      if (auto const *variable = dyn_cast<VarDecl>(name->getDecl())) changed.insert(variable);
  }

  SourceManager const &sources_;
};

// The names that the statement gives values in any case.
void collect_assigned(Stmt const *statement, llvm::SmallPtrSetImpl<Expr const *> &names) {
  if (auto const *loop = dyn_cast_or_null<ForStmt>(statement)) return collect_assigned(loop->getInit(), names);
  auto const *binary = dyn_cast_or_null<BinaryOperator>(statement);
  if (!binary) return;
  if (binary->getOpcode() == BO_Assign) names.insert(binary->getLHS()->IgnoreParens());
  if (binary->getOpcode() == BO_Assign || binary->isCommaOp()) collect_assigned(binary->getRHS(), names);
  if (binary->isCommaOp()) collect_assigned(binary->getLHS(), names);
}

// A block kernel, from the pragma that begins it to the one that ends it.
struct Block {
  PragmaFact *pragma;
  std::size_t begin, end;
  std::set<std::string> annotated; // whole variables, which need not be listed
};

bool annotates(PragmaFact const &pragma) {
  return std::any_of(pragma.clauses.begin(), pragma.clauses.end(),
                     [](ClauseFact const &clause) { return info(clause.clause).has(trait::GIVEN | trait::KEPT); });
}

std::map<std::string, std::vector<Block>> find_blocks(Facts &facts) {
  std::map<std::string, std::vector<Block>> blocks;
  std::map<std::string, Block> open;
  for (auto &[span, pragma] : facts.pragmas) { // by file and place
    if (pragma.is_function || pragma.configured) continue;
    if (!open.contains(span.file) && annotates(pragma)) open[span.file] = {&pragma, span.begin, span.end, {}};
    auto const found = open.find(span.file);
    if (found == open.end()) continue;
    for (ClauseFact const &clause : pragma.clauses)
      for (ItemFact const &item : clause.items)
        if (clause.clause != Clause::output && item.base_is_name && item.sections.empty())
          found->second.annotated.insert(item.label);
    if (!pragma.clause(Clause::generate)) continue;
    found->second.end = span.begin;
    blocks[span.file].push_back(found->second);
    open.erase(found);
  }
  return blocks;
}

} // namespace

class BlockFunctions : public Walk {
public:
  BlockFunctions(SourceMap const &map, Reals const &reals, ScalarState const &scalars, Surroundings &found,
                 std::map<std::string, std::vector<Block>> blocks)
      : map_(map),
        reals_(reals),
        scalars_(scalars),
        found_(found),
        blocks_(std::move(blocks)) {}

  bool shouldVisitTemplateInstantiations() const override { return false; }

  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (!function->doesThisDeclarationHaveABody() || !map_.in_roots(function->getLocation())) return true;
    std::optional<Span> const body = map_.range(function->getBody()->getSourceRange());
    if (!body) return true;
    auto const blocks = blocks_.find(body->file);
    if (blocks == blocks_.end()) return true;
    Mentions mentions(map_.sources());
    mentions.TraverseStmt(function->getBody());
    mentions_ = std::move(mentions.found);
    changed_ = std::move(mentions.changed);
    for (Block const &block : blocks->second) {
      if (block.begin < body->begin || body->end < block.end) continue;
      assigned_.clear();
      look_down(block, function->getBody());
      for (ParmVarDecl const *parameter : function->parameters()) add(block, parameter);
    }
    return true;
  }

private:
  std::size_t begin_of(Stmt const *statement) const { return offset(statement->getBeginLoc()); }
  std::size_t offset(SourceLocation location) const {
    return map_.sources().getFileOffset(map_.sources().getExpansionLoc(location));
  }
  bool holds(Stmt const *statement, Block const &block) const {
    return begin_of(statement) < block.begin && block.begin < offset(statement->getEndLoc());
  }

  // Down to where the block begins.
  void look_down(Block const &block, Stmt const *statement) {
    Stmt const *inner = nullptr;
    for (Stmt const *part : statement->children())
      if (part && holds(part, block) && !isa<DeclStmt>(part)) inner = part;
    if (inner)
      look_down(block, inner);
    else
      for (Stmt const *part : statement->children())
        if (part && begin_of(part) > block.begin) collect_assigned(part, assigned_);
    for (Stmt const *part : statement->children())
      if (auto const *declarations = dyn_cast_or_null<DeclStmt>(part); declarations && begin_of(part) < block.begin)
        for (Decl const *one : declarations->decls())
          if (auto const *variable = dyn_cast<VarDecl>(one)) add(block, variable);
  }

  void add(Block const &block, VarDecl const *variable) {
    add_lead(block, variable);
    QualType const type = variable->getType();
    ASTContext const &context = variable->getASTContext();
    if (!variable->getIdentifier() || !variable->hasLocalStorage() || type->isReferenceType()) return;
    if (context.getBaseElementType(type).isConstQualified() || type->isVariablyModifiedType()) return;
    if (variable->isConstexpr() || reals_.is_passive(variable)) return;
    if (block.annotated.contains(variable->getName().str())) return;
    bool const is_scalar = !type->isDependentType() && ScalarState::is_scalar(type);
    bool const holds = type->isDependentType() || reals_.carries_real(type) || scalars_.holds(type);
    if (!is_scalar && !holds) return;
    std::vector<Mention> const &mentions = mentions_of(variable);
    bool const has_value =
        variable->hasInit() || isa<ParmVarDecl>(variable) || (!mentions.empty() && mentions[0].offset < block.begin);
    if (!has_value || (is_scalar && !is_read_first(block, mentions))) return;
    block.pragma->around.push_back({variable->getName().str(), map_.place(variable->getLocation())});
    if (!is_scalar) found_.blocks_[variable].emplace_back(block.begin, block.end);
  }

  // Notes a pointer that selects constants before the block.
  void add_lead(Block const &block, VarDecl const *variable) const {
    if (!variable->getIdentifier() || !variable->hasLocalStorage() || !mentions_.contains(variable)) return;
    if (!variable->hasInit() && !isa<ParmVarDecl>(variable) && !changed_.contains(variable)) return;
    if (std::string lead = Storage::lead_from(variable); !lead.empty() && !leads_always_to_one(variable))
      block.pragma->leads.push_back(std::move(lead));
  }

  bool leads_always_to_one(VarDecl const *variable) const {
    Expr const *target = variable->getInit();
    if (!target || target->isInstantiationDependent() || changed_.contains(variable)) return false;
    Expr::EvalResult result;
    ASTContext const &context = variable->getASTContext();
    return variable->getType()->isReferenceType() ? target->EvaluateAsLValue(result, context)
                                                  : target->EvaluateAsRValue(result, context);
  }

  // Mentions of the variable in text order.
  std::vector<Mention> const &mentions_of(VarDecl const *variable) {
    std::vector<Mention> &mentions = mentions_[variable];
    std::sort(mentions.begin(), mentions.end(), [](Mention const &a, Mention const &b) { return a.offset < b.offset; });
    return mentions;
  }

  // A scalar is not traced; it counts if the block begins with a use of it.
  bool is_read_first(Block const &block, std::vector<Mention> const &mentions) const {
    auto const first = std::find_if(mentions.begin(), mentions.end(),
                                    [&block](Mention const &one) { return one.offset > block.begin; });
    return first != mentions.end() && first->offset < block.end && !assigned_.contains(first->name);
  }

  SourceMap const &map_;
  Reals const &reals_;
  ScalarState const &scalars_;
  Surroundings &found_;
  std::map<std::string, std::vector<Block>> blocks_;
  std::map<VarDecl const *, std::vector<Mention>> mentions_; // in the function
  llvm::SmallPtrSet<VarDecl const *, 8> changed_;            // there
  llvm::SmallPtrSet<Expr const *, 8> assigned_;              // where the block begins
};

Surroundings::Surroundings(ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
                           Facts &facts)
    : map_(map) {
  auto blocks = find_blocks(facts);
  if (!blocks.empty())
    BlockFunctions(map, reals, scalars, *this, std::move(blocks)).TraverseDecl(context.getTranslationUnitDecl());
}

bool Surroundings::contain(VarDecl const *variable, SourceLocation mention) const {
  auto const found = blocks_.find(variable);
  if (found == blocks_.end()) return false;
  SourceManager const &sources = map_.sources();
  std::size_t const at = sources.getFileOffset(sources.getExpansionLoc(mention));
  return llvm::any_of(found->second, [at](auto const &block) { return block.first < at && at < block.second; });
}

} // namespace symreal::rewrite
