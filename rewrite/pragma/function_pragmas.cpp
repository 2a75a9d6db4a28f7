#include "rewrite/pragma/function_pragmas.h"

#include "rewrite/model/object_layout.h"
#include "rewrite/model/signature.h"
#include "rewrite/model/storage.h"
#include "rewrite/pragma/pragma_items.h"
#include "rewrite/source/walk.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>

namespace symreal::rewrite {
namespace {

using namespace clang;

// The definition's own names, innermost scope first: parameters, members, namespaces.
ValueDecl const *look_up(std::string const &name, FunctionDecl const *function) {
  for (ParmVarDecl const *parameter : function->parameters())
    if (parameter->getName() == name) return parameter;
  DeclarationName const wanted = &function->getASTContext().Idents.get(name);
  for (DeclContext const *scope = function->getDeclContext(); scope; scope = scope->getLookupParent()) {
    for (NamedDecl const *found : scope->lookup(wanted))
      if (auto const *value = dyn_cast<ValueDecl>(found)) return value;
    for (UsingDirectiveDecl const *used : scope->using_directives()) // namespaces without a name are among them
      for (NamedDecl const *found : used->getNominatedNamespace()->lookup(wanted))
        if (auto const *value = dyn_cast<ValueDecl>(found)) return value;
    auto const *record = dyn_cast<CXXRecordDecl>(scope);
    if (!record || !record->hasDefinition()) continue;
    ValueDecl const *inherited = nullptr;
    record->forallBases([&](CXXRecordDecl const *base) {
      for (NamedDecl const *found : base->lookup(wanted))
        if (auto const *value = dyn_cast<ValueDecl>(found)) inherited = value;
      return true;
    });
    if (inherited) return inherited;
  }
  return nullptr;
}

// The places where a pragma may stand before the definition: parameters of templates and their constraints may hold
// braces.
std::vector<SourceLocation> beginnings(FunctionDecl const *function) {
  std::vector<SourceLocation> all = {function->getBeginLoc()};
  for (unsigned i = 0; i < function->getNumTemplateParameterLists(); ++i)
    all.push_back(function->getTemplateParameterList(i)->getTemplateLoc());
  if (FunctionTemplateDecl const *described = function->getDescribedFunctionTemplate())
    all.push_back(described->getTemplateParameters()->getTemplateLoc());
  std::erase_if(all, [](SourceLocation one) { return one.isInvalid(); }); // of `auto` parameters alone
  return all;
}

auto names_of(FunctionDecl const *function) {
  return [function](std::string const &name) { return look_up(name, function); };
}

// Whether the function changes the variable itself, as in `n--` or `*out++ = x`.
class Changes : public Walk {
public:
  explicit Changes(ValueDecl const *variable) : variable_(variable) {}
  bool VisitUnaryOperator(UnaryOperator *unary) override {
    return !(unary->isIncrementDecrementOp() && is_it(unary->getSubExpr())) || note(unary->getOperatorLoc());
  }
  bool VisitBinaryOperator(BinaryOperator *binary) override {
    return !(binary->isAssignmentOp() && is_it(binary->getLHS())) || note(binary->getOperatorLoc());
  }
  SourceLocation place;

private:
  bool is_it(Expr const *expression) const {
    auto const *reference = dyn_cast<DeclRefExpr>(expression->IgnoreParenImpCasts());
    return reference && reference->getDecl() == variable_;
  }
  bool note(SourceLocation location) {
    place = location;
    return false; // one is enough
  }
  ValueDecl const *variable_;
};

class Attacher {
public:
  Attacher(SourceMap const &map, Reals const &reals, ScalarState const &scalars,
           std::vector<PragmaIndex::Name> const &names, Facts &facts)
      : map_(map),
        reals_(reals),
        scalars_(scalars),
        names_(names),
        facts_(facts) {}

  void attach(Span const &span, SourceLocation start, std::vector<FunctionDecl const *> const &definitions) {
    FileID const file = map_.sources().getFileID(start);
    FunctionDecl const *next = nullptr;
    unsigned next_offset = 0;
    for (FunctionDecl const *function : definitions)
      for (SourceLocation const begin : beginnings(function)) {
        auto const [at, offset] = map_.sources().getDecomposedExpansionLoc(begin);
        if (at == file && offset >= span.end && (!next || offset < next_offset)) next = function, next_offset = offset;
      }
    std::string const text = map_.sources().getBufferData(file).str();
    if (!next || !only_declaration_start(text.substr(span.end, next_offset - span.end))) {
      report(DiagnosticId::pragma_unattached, start, "no function definition follows this pragma");
      return;
    }
    attach_to(span, next);
  }

  void attach_to(Span const &span, FunctionDecl const *function) {
    PragmaFact &pragma = facts_.pragmas[span];
    note_function(pragma, function);
    if (pragma.function.empty() || !pragma.is_kernel()) return;
    Redefinition &redefined = pragma.function[0].signature.redefinition;
    redefined = redefinition(function, look_up_names(span, function));
    redefined.file = pragma.function[0].brace.file;
    redefined.body =
        map_.sources().getFileOffset(map_.sources().getExpansionLoc(block_of(function)->getBeginLoc())) + 1;
    redefined.is_template = function->isTemplated();
    redefined.baked = baked_values(function, items_of(pragma, function), pragma.place);
    redefined.overlaps = possible_overlaps(function, placed_items(pragma, function));
    redefined.result = returned_object(function);
    if (function->getReturnType()->isVoidType())
      refuse_returned(pragma);
    else
      wrap_returns(pragma, function);
  }

private:
  void report(DiagnosticId id, SourceLocation location, std::string message) {
    facts_.diagnostics.push_back({id, map_.place(location), std::move(message)});
  }

  static std::vector<BakedItem> items_of(PragmaFact const &pragma, FunctionDecl const *function) {
    std::vector<BakedItem> items;
    auto const find = names_of(function);
    for (ClauseFact const &clause : pragma.clauses)
      for (ItemFact const &item : clause.items)
        if (!item.is_return && (takes_numbers(clause) || clause.clause == Clause::constant))
          items.push_back({item.label, item.base, item.sections, item.place,
                           type_of_item(item.expression, function->getASTContext(), function, find).type,
                           clause.clause == Clause::constant});
    return items;
  }

  static std::vector<PlacedItem> placed_items(PragmaFact const &pragma, FunctionDecl const *function) {
    std::vector<PlacedItem> items;
    auto const find = names_of(function);
    for (ClauseFact const &clause : pragma.clauses)
      for (ItemFact const &item : clause.items) {
        if (item.is_return || !takes_numbers(clause)) continue;
        PlacedItem placed{item.label, item.base, item.sections.size(), info(clause.clause).has(trait::RESULTS)};
        placed.base_type = type_of_item(item.base, function->getASTContext(), function, find).type;
        std::size_t begin = item.base.find_first_not_of("*&( ");
        if (begin == item.base.npos) continue;
        if (item.base.compare(begin, 6, "this->") == 0) begin += 6;
        std::size_t end = begin;
        while (end < item.base.size() && isAsciiIdentifierContinue(item.base[end])) ++end;
        placed.root_name = item.base.substr(begin, end - begin);
        placed.root = look_up(placed.root_name, function);
        items.push_back(std::move(placed));
      }
    return items;
  }

  void note_function(PragmaFact &pragma, FunctionDecl const *function) {
    auto const [file, begin] = map_.sources().getDecomposedExpansionLoc(function->getBeginLoc());
    llvm::StringRef const text = map_.sources().getBufferData(file);
    std::optional<Span> const brace = entry_of(function, map_);
    if (!brace) {
      report(DiagnosticId::pragma_unattached, function->getLocation(), "the function's body is made by a macro");
      return;
    }
    FunctionFact fact{.name = function->getNameAsString(),
                      .signature = {},
                      .brace = *brace,
                      .values = {},
                      .parameters = {},
                      .leads = {},
                      .is_template = function->isDependentContext()};
    unsigned end = map_.sources().getFileOffset(map_.sources().getExpansionLoc(function->getBody()->getBeginLoc()));
    if (auto const *constructor = dyn_cast<CXXConstructorDecl>(function))
      for (CXXCtorInitializer const *initializer : constructor->inits())
        if (initializer->isWritten())
          end = std::min(
              end, map_.sources().getFileOffset(map_.sources().getExpansionLoc(initializer->getSourceLocation())));
    fact.signature = {normalised(text.substr(begin, end - begin).str()), {}, !function->getReturnType()->isVoidType()};
    if (std::optional<Signature> const plain = plain_declaration(function, map_.language())) fact.signature = *plain;
    for (ParmVarDecl const *parameter : function->parameters())
      if (parameter->getIdentifier() && !Storage::is_view(parameter->getType()) &&
          (reals_.carries_real(parameter->getType()) ||
           (parameter->isReferenced() && scalars_.holds(parameter->getType()) &&
            !ScalarState::is_opaque(parameter->getType()) && !ScalarState::is_function_pointer(parameter->getType()))))
        fact.values.push_back({parameter->getName().str(), map_.place(parameter->getLocation())});
    constexpr unsigned in_registers = 6; // at least, of the calling conventions in use
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    unsigned const passed = function->getNumParams() + (method && method->isInstance() ? 1 : 0);
    for (ParmVarDecl const *parameter : function->parameters())
      if (parameter->getIdentifier() && !parameter->getType()->isReferenceType() &&
          (passed > in_registers || parameter->getType()->isRecordType()))
        fact.parameters.push_back({parameter->getName().str(), map_.place(parameter->getLocation())});
    for (ParmVarDecl const *parameter : function->parameters())
      if (std::string lead = Storage::lead_from(parameter); parameter->isReferenced() && !lead.empty())
        fact.leads.push_back(std::move(lead));
    if (method && method->isInstance()) fact.leads.emplace_back("this");
    pragma.function = {fact};
  }

  std::vector<NamedItem> look_up_names(Span const &span, FunctionDecl const *function) {
    PragmaFact &pragma = facts_.pragmas[span];
    std::vector<NamedItem> named;
    for (PragmaIndex::Name const &name : names_) {
      if (name.item.pragma != span) continue;
      ItemFact &item = pragma.clauses[name.item.clause].items[name.item.item];
      ValueDecl const *declaration = look_up(name.text, function);
      if (!declaration) {
        std::string const where = "'" + name.text + "' is neither a parameter of '" + function->getNameAsString() +
                                  "' nor declared before it";
        facts_.diagnostics.push_back({DiagnosticId::pragma_undeclared_name, name.place, where});
        item.seen = item.carries_real = true; // one error is enough
        continue;
      }
      ClauseInfo const &clause = info(pragma.clauses[name.item.clause].clause);
      bool const is_compared = clause.clause == Clause::constant; // by a wrapper
      if (clause.has(trait::GIVEN | trait::RESULTS) || is_compared) named.push_back({name.text, declaration});
      // Outputs are read when the function returns, so the names that locate them must be unchanged then.
      bool const locates = !name.is_base || item.section_on_base;
      if (clause.has(trait::RESULTS) && locates && isa<ParmVarDecl>(declaration))
        refuse_changes(item, name.text, declaration, function);
      if (!name.is_base) continue;
      item.seen = true;
      item.type = declaration->getType().getAsString();
      item.carries_real = declaration->getType()->isDependentType() || reals_.mentions_real(declaration->getType());
      item.holds_scalar = holds_scalar(declaration->getType());
      note_declaration(item, declaration);
    }
    auto const find = names_of(function);
    for (ClauseFact &clause : pragma.clauses)
      for (ItemFact &item : clause.items) {
        if (!item.seen)
          item.seen = item.carries_real = true; // it does not begin with a plain name: its type is unknown
        if (item.is_return) continue;
        ItemType const type = type_of_item(item.expression, function->getASTContext(), function, find);
        note_bounds(clause, item, type.indices, find, facts_);
        if (!takes_numbers(clause)) continue;
        if (is_pointee(item))
          if (ValueDecl const *pointer = find(item.label.substr(1)))
            item.base_kind = kind_of(pointer, function->getASTContext());
        note_layout(clause, item, type, function->getASTContext(), reals_, facts_);
      }
    return named;
  }

  // Whether the object, or its target, holds a scalar: a container has a number of elements, a smart pointer an
  // address.
  bool holds_scalar(QualType type) const {
    while ((type->isPointerType() && !type->isFunctionPointerType()) || type->isReferenceType() || type->isArrayType())
      type = type->isArrayType() ? type->getAsArrayTypeUnsafe()->getElementType() : type->getPointeeType();
    return type->isRecordType() || scalars_.holds(type);
  }

  void refuse_changes(ItemFact const &item, std::string const &name, ValueDecl const *declaration,
                      FunctionDecl const *function) {
    Changes changes(declaration);
    changes.TraverseStmt(function->getBody());
    if (changes.place.isInvalid()) return;
    std::string const message = "'" + item.label + "' is read when the function returns, but '" + name + "' changes";
    facts_.diagnostics.push_back(
        {DiagnosticId::pragma_item, item.place, message, {{map_.place(changes.place), "it is changed here"}}});
  }

  void refuse_returned(PragmaFact const &pragma) {
    for (ClauseFact const &clause : pragma.clauses)
      for (ItemFact const &item : clause.items)
        if (item.is_return)
          facts_.diagnostics.push_back(
              {DiagnosticId::pragma_item, item.place, "'" + pragma.function[0].name + "' returns nothing"});
  }

  // Integer type as text that is valid in C and C++.
  static std::string integer_words(QualType type) {
    if (auto const *enumeration = type->getAs<EnumType>()) type = enumeration->getDecl()->getIntegerType();
    type = type.getCanonicalType().getUnqualifiedType();
    return type->isBooleanType() ? "SYMREAL_BOOL" : type.getAsString();
  }

  // Reason why a value of this type cannot be an output; empty if it can be.
  std::string unfit_as_output(QualType type, ASTContext const &context) const {
    std::string const name = declared(type.getUnqualifiedType(), "", context);
    std::string const what = "output(return): it is " + name + ", ";
    if (type->isPointerType() || (type->isLValueReferenceType() && !type->getPointeeType().isConstQualified()))
      return what + "which hands out an object: name that in output(...)";
    QualType const value = type.getNonReferenceType().getUnqualifiedType();
    if (value->isRealFloatingType() && !Reals::is_double(value)) return what + "which holds no double";
    auto const *record = value->getAsCXXRecordDecl();
    if (!record || !record->hasDefinition() || !record->isInStdNamespace() || !record->getIdentifier()) return "";
    constexpr llvm::StringLiteral walked[] = {"complex", "pair", "array"};
    if (llvm::is_contained(walked, record->getName()) || !element_of(record->getDefinition()).isNull()) return "";
    return what + "whose numbers no annotation reaches: return a structure or an array of them";
  }

  void wrap_returns(PragmaFact &pragma, FunctionDecl const *function) {
    ItemFact *returned = nullptr;
    for (ClauseFact &clause : pragma.clauses)
      for (ItemFact &item : clause.items)
        if (clause.clause == Clause::output && item.is_return) {
          std::string const reason = unfit_as_output(function->getReturnType(), function->getASTContext());
          if (!reason.empty()) return facts_.diagnostics.push_back({DiagnosticId::pragma_item, item.place, reason});
          returned = &item;
          note_layout(clause, item, {function->getReturnType(), false}, function->getASTContext(), reals_, facts_);
        }
    QualType const type = function->getReturnType();
    bool const is_object = type->isRecordType() || type->isDependentType();
    if (!returned && !is_object) return;
    std::string const place = returned ? place_arguments("return", returned->place) : "";
    bool const is_integer = type->isIntegralOrEnumerationType();
    if (is_integer && function->getASTContext().getTypeSize(type) > 32)
      return facts_.diagnostics.push_back(
          {DiagnosticId::pragma_item, returned->place,
           "'" + pragma.function[0].name + "' returns an integer of more than 32 bits, which no output holds"});
    std::string usual = returned ? "(" + place : "";
    if (is_integer) usual = "_INTEGER(" + place + ", (" + integer_words(type) + ")";
    if (returned && !returned->layout.text.empty())
      usual = "_LAYOUT(" + place + ", " + layout_arguments(returned->layout);
    if (returned) pragma.function[0].signature.redefinition.result.begin = "SYMREAL_RETURN" + usual;
    std::string const as = type_in_words(function);
    for (ReturnStmt const *statement : returns_of(function)) {
      Expr const *value = statement->getRetValue();
      if (!value) continue;
      // A macro would take `a, b` for two arguments.
      while (auto const *comma = dyn_cast<BinaryOperator>(value->IgnoreImplicit())) {
        if (comma->getOpcode() != BO_Comma) break;
        value = comma->getRHS();
      }
      std::optional<Span> const span = map_.range(value->getSourceRange());
      bool const is_list = span && map_.text(*span, value->getBeginLoc()).starts_with('{');
      bool const is_converted = is_list || !function->getASTContext().hasSameUnqualifiedType(
                                               value->IgnoreUnlessSpelledInSource()->getType(), type);
      bool const is_from_class = value->IgnoreUnlessSpelledInSource()->getType()->isRecordType();
      bool const is_made_first = is_converted && !as.empty() && !is_integer && (is_list || is_object || is_from_class);
      if (returned && (!span || (is_list && !is_made_first)))
        report(DiagnosticId::pragma_item, statement->getReturnLoc(),
               "output(return) needs `return` with an expression");
      if (!span || (!returned && as.empty())) continue;
      std::string macro = returned ? usual : "_WHOLE(" + as;
      if (returned && is_made_first) macro = macro.insert(macro.find('('), "_AS") + ", " + as;
      facts_.wraps.insert({*span, Use::returned, macro});
    }
  }

  // The returned type in parentheses, as the function itself can write it; empty if it cannot.
  static std::string type_in_words(FunctionDecl const *function) {
    QualType const type = function->getReturnType();
    ASTContext const &context = function->getASTContext();
    if (!context.getLangOpts().CPlusPlus) return type->isRecordType() ? "(" + type.getAsString() + ")" : "";
    if (type->isDependentType() || type->getContainedAutoType()) return "";
    return "(" + with_real(type_text(type.getCanonicalType().getUnqualifiedType(), context)) + ")";
  }

  SourceMap const &map_;
  Reals const &reals_;
  ScalarState const &scalars_;
  std::vector<PragmaIndex::Name> const &names_;
  Facts &facts_;
};

} // namespace

void attach_function_pragmas(std::vector<FunctionDecl const *> const &definitions, SourceMap const &map,
                             Reals const &reals, ScalarState const &scalars, PragmaIndex const &index, Facts &facts) {
  Attacher attacher(map, reals, scalars, index.function_names, facts);
  for (auto const &[span, start] : index.function_pragmas)
    if (facts.pragmas[span].function.empty()) attacher.attach(span, start, definitions);
}

void attach_pragma(Span const &span, FunctionDecl const *definition, std::vector<PragmaIndex::Name> const &names,
                   SourceMap const &map, Reals const &reals, ScalarState const &scalars, Facts &facts) {
  Attacher(map, reals, scalars, names, facts).attach_to(span, definition);
}

std::optional<Span> entry_of(FunctionDecl const *function, SourceMap const &map) {
  auto const *attempt = dyn_cast_or_null<CXXTryStmt>(function->getBody());
  // Members live before the block of a constructor, and until after that of a destructor; their handlers throw again.
  if (!attempt || isa<CXXConstructorDecl, CXXDestructorDecl>(function))
    return map.token(block_of(function)->getBeginLoc());
  std::optional<Span> const word = map.token(attempt->getTryLoc());
  std::optional<Span> const last = map.token(attempt->getEndLoc());
  if (!word || !last || word->file != last->file) return std::nullopt;
  return Span{word->file, word->begin, last->end};
}

Stmt const *block_of(FunctionDecl const *function) {
  Stmt const *body = function->getBody();
  auto const *attempt = dyn_cast_or_null<CXXTryStmt>(body);
  return attempt ? attempt->getTryBlock() : body;
}

} // namespace symreal::rewrite
