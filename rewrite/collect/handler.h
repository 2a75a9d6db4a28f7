// Base of the handlers of syntax, and the table of what they meet. A handler is a class in the file of its concept: its
// constructor makes a row for each kind of syntax that it meets, and it adds facts about that. It edits nothing.
#pragma once

#include "rewrite/collect/call_site.h"
#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/model/surroundings.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <vector>

namespace symreal::rewrite {

// The part of the tree at which a walk is.
struct Position {
  Passive passive = not_passive;                 // double stays double
  bool in_template = false;                      // types may depend on its arguments
  clang::FunctionDecl const *function = nullptr; // around it
  bool is_template_value = false;                // an argument of a template, which the compiler evaluates
};

// A source, what is known of it beforehand, and the facts about it that handlers collect.
struct Collection {
  clang::ASTContext &context;
  SourceMap const &map;
  Reals const &reals;
  ScalarState const &scalars;
  Surroundings const &surroundings;
  Facts &facts;

  Position at = {};
  std::optional<Note> instance = {}; // the instantiation that is walked

  // Expressions of which handlers tell each other. They are asked for only in what is put off to the end, so that no
  // order between handlers matters.
  //
  // Names of objects whose use is noted: by each note, and by stores, which overwrite unions. Asked for by unions and
  // by names in templates.
  llvm::SmallPtrSet<clang::Expr const *, 32> judged = {};
  // Implicit conversions that the syntax around them has spelled out, or that need no text: by comparisons, and by
  // calls and choices in C. Asked for by conversions.
  llvm::SmallPtrSet<clang::Expr const *, 8> settled = {};

  struct Waiting {
    std::optional<Note> instance;
    std::function<void()> action;
  };
  std::vector<Waiting> soon = {}, later = {};
};

// Kinds of syntax that are met: a node as each class that it is of, from the root of Clang's hierarchy on, a call or
// construction as a CallSite as well.
// clang-format off
#define SYMREAL_MET_STATEMENTS(KIND)                                                                                   \
  KIND(Stmt) KIND(AbstractConditionalOperator) KIND(AtomicExpr) KIND(BinaryOperator) KIND(CallExpr) KIND(CastExpr)     \
  KIND(CompoundAssignOperator) KIND(ConditionalOperator) KIND(CXXConstructExpr) KIND(CXXDynamicCastExpr)               \
  KIND(CXXForRangeStmt) KIND(CXXMemberCallExpr) KIND(CXXNewExpr) KIND(CXXRewrittenBinaryOperator) KIND(CXXThrowExpr)   \
  KIND(CXXTypeidExpr) KIND(DeclRefExpr) KIND(DoStmt) KIND(ExplicitCastExpr) KIND(ForStmt) KIND(GCCAsmStmt)             \
  KIND(GenericSelectionExpr) KIND(IfStmt) KIND(ImplicitCastExpr) KIND(InitListExpr) KIND(IntegerLiteral)               \
  KIND(LambdaExpr) KIND(MemberExpr) KIND(PredefinedExpr) KIND(ReturnStmt) KIND(UnaryExprOrTypeTraitExpr)               \
  KIND(UnaryOperator) KIND(UserDefinedLiteral) KIND(WhileStmt)
#define SYMREAL_MET_DECLARATIONS(KIND) KIND(FunctionDecl) KIND(NamedDecl) KIND(RecordDecl) KIND(VarDecl)
#define SYMREAL_MET_TYPES(KIND)                                                                                        \
  KIND(BuiltinTypeLoc) KIND(ComplexTypeLoc) KIND(DecltypeTypeLoc) KIND(ElaboratedTypeLoc) KIND(TypeOfExprTypeLoc)
// clang-format on

// Places where a handler meets it; rows combine these.
enum : unsigned char {
  ANYWHERE = 1,  // in the text of the program
  NUMBERS = 2,   // where double becomes REAL
  RUNNING = 4,   // where it does, and values are used while the program runs: not in the operand of sizeof
  INSTANCES = 8, // in an instantiation of a template, whose text it shares
};

template <class Syntax> using Node = std::conditional_t<std::is_base_of_v<clang::TypeLoc, Syntax> ||
                                                            std::is_same_v<Syntax, clang::NestedNameSpecifierLoc>,
                                                        Syntax, Syntax const *>;

class SyntaxHandler;

class SyntaxTable {
public:
  // With the rows of all handlers (table.cpp).
  explicit SyntaxTable(Collection all);
  ~SyntaxTable();
  SyntaxTable(SyntaxTable const &) = delete;
  SyntaxTable &operator=(SyntaxTable const &) = delete;

  template <class Syntax> void meet(Node<Syntax> node, unsigned where, Position const &at) {
    all_.at = at;
    for (auto const &[here, action] : rows<Syntax>())
      if ((here & where) != 0) action(node);
    if constexpr (std::is_same_v<Syntax, clang::CallExpr> || std::is_same_v<Syntax, clang::CXXConstructExpr>)
      if (std::optional<CallSite> const site = call_site(node)) meet<CallSite>(&*site, where, at);
  }
  void set_instance(std::optional<Note> instance) { all_.instance = std::move(instance); }
  // Does what handlers have put off.
  void finish();

  template <class One, class... More> One &add(More &...more) {
    auto handler = std::make_unique<One>(*this, more...);
    One &result = *handler;
    handlers_.push_back(std::move(handler));
    return result;
  }

private:
  friend class SyntaxHandler;
  template <class Syntax> using Rows = std::vector<std::pair<unsigned, std::function<void(Node<Syntax>)>>>;
  template <class Syntax> Rows<Syntax> &rows() { return std::get<Rows<Syntax>>(rows_); }

#define MET(SYNTAX) Rows<clang::SYNTAX>,
  std::tuple<SYMREAL_MET_STATEMENTS(MET) SYMREAL_MET_DECLARATIONS(MET) SYMREAL_MET_TYPES(MET)
                 MET(NestedNameSpecifierLoc) MET(concepts::ExprRequirement) Rows<CallSite>>
      rows_;
#undef MET
  Collection all_;
  std::vector<std::unique_ptr<SyntaxHandler>> handlers_;
};

class SyntaxHandler {
public:
  explicit SyntaxHandler(SyntaxTable &table)
      : all_(table.all_),
        context_(all_.context),
        map_(all_.map),
        reals_(all_.reals),
        facts_(all_.facts),
        at_(all_.at),
        instance_(all_.instance),
        table_(table) {}
  SyntaxHandler(SyntaxHandler const &) = delete;
  SyntaxHandler &operator=(SyntaxHandler const &) = delete;
  virtual ~SyntaxHandler() = default;
  // All syntax is met, and what was put off is done.
  virtual void finish() {}

protected:
  using Arguments = llvm::ArrayRef<clang::Expr const *>;

  template <class Syntax, class One> void on(unsigned where, void (One::*action)(Node<Syntax>)) {
    auto &handler = static_cast<One &>(*this);
    table_.rows<Syntax>().emplace_back(where, [&handler, action](Node<Syntax> node) { (handler.*action)(node); });
  }

  // Puts an action off until all syntax is met: it depends on facts from others about the same expression.
  void later(std::function<void()> action) { all_.later.push_back({instance_, std::move(action)}); }
  // The same before all that: it depends on what the handler has noted of the syntax around.
  void soon(std::function<void()> action) { all_.soon.push_back({instance_, std::move(action)}); }

  void wrap(clang::Expr const *expression, Use use, std::string detail = {});
  // Wraps the expression for `user` alone (SourceMap::range_for).
  std::optional<Span> wrap_for(clang::SourceLocation user, clang::Expr const *expression, Use use,
                               std::string detail = {});
  // Spells an implicit conversion out.
  void convert(clang::Expr const *expression, Use use, std::string type);
  void report(DiagnosticId id, clang::SourceLocation location, std::string message,
              std::optional<Severity> unusual = {});

  // The type as a cast or a macro argument spells it in any scope: value_type is a name in its class only.
  std::string spelled(clang::QualType type) const;
  // Whether an initializer or argument is a literal that stays double in the symbolic program.
  bool is_plain_double(clang::Expr const *expression) const;
  // Whether the integer may be of a class in the symbolic program (calls.cpp).
  bool may_be_truth(clang::Expr const *argument) const;
  // Whether C converts pointers there that C++ does not (conversions.cpp).
  bool is_pointer_of_c(clang::ImplicitCastExpr const *cast) const;
  // The integer type of an enumeration's expression (c_types.cpp).
  clang::QualType counted_as(clang::Expr const *enumeration) const;
  // Elements of a list as conversions and copies have made them; the walk meets them as they were parsed.
  static llvm::ArrayRef<clang::Expr *> converted_elements(clang::InitListExpr const *list);

  Collection &all_;
  clang::ASTContext &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Facts &facts_;
  Position const &at_;
  std::optional<Note> const &instance_;

private:
  SyntaxTable &table_;
};

} // namespace symreal::rewrite
