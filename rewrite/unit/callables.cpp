#include "rewrite/unit/callables.h"

#include "rewrite/model/plain_declaration.h"
#include "rewrite/source/source_map.h"
#include "rewrite/source/walk.h"
#include "rewrite/unit/collect_source.h"

#include <algorithm>
#include <clang/AST/QualTypeNames.h>

namespace symreal::rewrite {
namespace {

using namespace clang;

bool is_default_constructible(QualType type) {
  CXXRecordDecl const *record = type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return !record;
  if (record->isAbstract()) return false;
  if (record->needsImplicitDefaultConstructor()) return record->hasDefaultConstructor();
  for (CXXConstructorDecl const *one : record->ctors())
    if (one->isDefaultConstructor()) return !one->isDeleted() && one->getAccess() == AS_public;
  for (Decl const *one : record->decls()) // a template all of whose parameters have defaults
    if (auto const *pattern = dyn_cast<FunctionTemplateDecl>(one))
      if (auto const *constructor = dyn_cast<CXXConstructorDecl>(pattern->getTemplatedDecl()))
        if (constructor->getMinRequiredArguments() == 0 && constructor->getAccess() == AS_public) return true;
  return false;
}

bool has_method(CXXRecordDecl const *record, llvm::StringRef name, unsigned parameters) {
  if (!record || !record->hasDefinition()) return false;
  for (NamedDecl const *found : record->lookup(&record->getASTContext().Idents.get(name)))
    if (auto const *method = dyn_cast<CXXMethodDecl>(found); method && method->getNumParams() == parameters)
      return true;
  bool inherited = false;
  for (CXXBaseSpecifier const &base : record->bases())
    inherited = inherited || has_method(base.getType()->getAsCXXRecordDecl(), name, parameters);
  return inherited;
}

// Numbers, arrays of them element by element, and what has elements, which is filled as a whole.
class PublicNumbers {
public:
  explicit PublicNumbers(ASTContext &context) : context_(context) {}

  std::vector<std::string> of(QualType type) {
    RecordType const *record = type->getAs<RecordType>();
    RecordDecl const *definition = record ? record->getDecl()->getDefinition() : nullptr;
    auto const *in_cxx = dyn_cast_or_null<CXXRecordDecl>(definition);
    if (definition && !(in_cxx && has_elements(in_cxx))) members(definition, "");
    return std::move(found_);
  }

private:
  static bool has_elements(CXXRecordDecl const *record) {
    return has_method(record, "size", 0) || has_method(record, "rows", 0);
  }

  void members(RecordDecl const *record, std::string const &path) {
    if (auto const *in_cxx = dyn_cast<CXXRecordDecl>(record))
      for (CXXBaseSpecifier const &base : in_cxx->bases())
        if (RecordType const *type = base.getType()->getAs<RecordType>();
            type && base.getAccessSpecifier() == AS_public)
          members(type->getDecl()->getDefinition(), path);
    for (FieldDecl const *field : record->fields()) {
      bool const is_public = field->getAccess() == AS_public || field->getAccess() == AS_none;
      if (!is_public || field->getType().isConstQualified()) continue;
      value(field->getType(), field->isAnonymousStructOrUnion() ? path : path + "." + field->getNameAsString());
    }
  }

  void value(QualType type, std::string const &path) {
    constexpr std::size_t most = 10'000;
    if (found_.size() >= most) return;
    if (type->isSpecificBuiltinType(BuiltinType::Double)) {
      found_.push_back(path);
    } else if (ConstantArrayType const *array = context_.getAsConstantArrayType(type)) {
      for (std::uint64_t k = 0; k < array->getSize().getZExtValue() && found_.size() < most; ++k)
        value(array->getElementType(), path + "[" + std::to_string(k) + "]");
    } else if (RecordType const *record = type->getAs<RecordType>(); record && record->getDecl()->getDefinition()) {
      auto const *in_cxx = dyn_cast<CXXRecordDecl>(record->getDecl()->getDefinition());
      if (in_cxx && has_elements(in_cxx))
        found_.push_back(path);
      else
        members(record->getDecl()->getDefinition(), path);
    }
  }

  ASTContext &context_;
  std::vector<std::string> found_;
};

class Describer {
public:
  Describer(ASTContext &context, SourceMap const &map) : context_(context), map_(map) {}

  Callable describe(FunctionDecl const *function) const {
    Callable result;
    result.name = function->getNameAsString();
    result.qualified = function->getQualifiedNameAsString();
    for (std::string const unnamed = "(anonymous namespace)::"; result.qualified.find(unnamed) != std::string::npos;)
      result.qualified.erase(result.qualified.find(unnamed), unnamed.size());
    result.is_c = !context_.getLangOpts().CPlusPlus;
    result.place = map_.place(function->getLocation());
    std::string types, declared_types, parameters;
    for (ParmVarDecl const *one : function->parameters()) {
      result.parameters.push_back(parameter(one));
      types += (types.empty() ? "" : ", ") + one->getType().getCanonicalType().getAsString(context_.getLangOpts());
      declared_types += (declared_types.empty() ? "" : ", ") + one->getType().getAsString(context_.getLangOpts());
      parameters +=
          (parameters.empty() ? "" : ", ") + declared(one->getOriginalType(), one->getNameAsString(), context_);
    }
    result.key = result.qualified + "(" + types + ")";
    result.declared_types = "(" + declared_types + ")";
    result.declaration = declared(function->getReturnType(), result.qualified + "(" + parameters + ")", context_);
    auto const *method = dyn_cast<CXXMethodDecl>(function);
    result.is_accessible = function->getAccess() == AS_public || function->getAccess() == AS_none;
    if (!method || method->isStatic()) return result;
    result.has_this = true;
    QualType const object = context_.getRecordType(method->getParent());
    result.object = declared(object, "", context_);
    result.object_default_constructible = is_default_constructible(object);
    return result;
  }

private:
  CallParameter parameter(ParmVarDecl const *from) const {
    using Kind = CallParameter::Kind;
    CallParameter to;
    QualType type = from->getType();
    to.name = from->getNameAsString();
    to.type = declared(from->getOriginalType(), "", context_);
    if (type->isRValueReferenceType()) to.moved = declared(type, "", context_);
    if (type->isReferenceType()) {
      type = type->getPointeeType();
      to.is_changed = !type.isConstQualified() && to.moved.empty();
    }
    type.removeLocalConst();
    type.removeLocalVolatile();
    if (type->isArrayType()) type = context_.getBaseElementType(type).isConstQualified() ? without_const(type) : type;
    to.variable = declared(type, "$", context_);
    to.default_constructible = is_default_constructible(type);
    CXXRecordDecl const *record = type->getAsCXXRecordDecl();
    if (type->isSpecificBuiltinType(BuiltinType::Double))
      to.kind = Kind::number;
    else if (type->isArithmeticType() || type->isEnumeralType()) {
      to.kind = Kind::integer;
      to.is_integral = type->isIntegerType() && !type->isEnumeralType() && !type->isBooleanType();
      to.holds_integer = type->isIntegralOrEnumerationType();
    } else if (type->isPointerType()) {
      point(to, type->getPointeeType());
      if (auto const *decayed = from->getType()->getAs<DecayedType>()) {
        auto const *array = dyn_cast<ConstantArrayType>(decayed->getOriginalType());
        for (; array; array = dyn_cast<ConstantArrayType>(array->getElementType()))
          to.extents.push_back(std::to_string(array->getSize().getZExtValue()));
      }
    } else if (has_method(record, "rows", 0) && has_method(record, "cols", 0) && has_method(record, "resize", 2)) {
      to.kind = is_dynamic_matrix(record) ? Kind::matrix : is_dynamic_vector(record) ? Kind::container : Kind::object;
      std::vector<int64_t> const all = sizes(record);
      to.is_matrix =
          to.kind == Kind::matrix || (to.kind == Kind::object && all.size() >= 2 && all[0] != 1 && all[1] != 1);
    } else if (has_method(record, "size", 0) && has_method(record, "resize", 1))
      to.kind = Kind::container;
    else if (type->isRecordType() || type->isArrayType()) {
      to.kind = Kind::object;
      to.members = PublicNumbers(context_).of(type);
    }
    return to;
  }

  // Eigen's sizes are arguments of its templates: -1 is one that is known at run time.
  static std::vector<int64_t> sizes(CXXRecordDecl const *record) {
    std::vector<int64_t> found;
    if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(record))
      for (TemplateArgument const &one : special->getTemplateArgs().asArray())
        if (one.getKind() == TemplateArgument::Integral) found.push_back(one.getAsIntegral().getExtValue());
    return found;
  }
  static bool is_dynamic_matrix(CXXRecordDecl const *record) {
    std::vector<int64_t> const all = sizes(record);
    return all.size() >= 2 && all[0] == -1 && all[1] == -1;
  }
  static bool is_dynamic_vector(CXXRecordDecl const *record) {
    std::vector<int64_t> const all = sizes(record);
    return all.size() >= 2 && (all[0] == -1) != (all[1] == -1);
  }

  QualType without_const(QualType type) const {
    if (auto const *array = context_.getAsConstantArrayType(type))
      return context_.getConstantArrayType(without_const(array->getElementType()), array->getSize(), nullptr,
                                           ArraySizeModifier::Normal, 0);
    return type.getUnqualifiedType();
  }

  void point(CallParameter &to, QualType pointee) const {
    bool const is_text = pointee->isAnyCharacterType();
    if (pointee->isFunctionType() || pointee->isVoidType() || pointee->isIncompleteType() || is_text) return;
    to.kind = CallParameter::Kind::pointer;
    QualType const element = without_const(pointee);
    to.pointee = declared(element, "$[#]", context_);
    if (auto const *inner = element->getAs<PointerType>())
      to.rows = declared(without_const(inner->getPointeeType()), "$[#][#]", context_);
    to.members = PublicNumbers(context_).of(element);
    to.points_to_numbers = !context_.getBaseElementType(element)->isRecordType();
    to.default_constructible = is_default_constructible(context_.getBaseElementType(element));
  }

  ASTContext &context_;
  SourceMap const &map_;
};

class Finder : public Walk {
public:
  Finder(ASTContext &context, SourceMap const &map, std::string const &name, std::vector<Callable> &found)
      : context_(context),
        describer_(context, map),
        name_(name),
        found_(found) {}

  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (!function->doesThisDeclarationHaveABody() || function->isTemplated() || function->isImplicit()) return true;
    if (!function->getDeclName().isIdentifier() || function->getName() != name_) return true;
    SourceManager const &sources = context_.getSourceManager();
    SourceLocation const place = sources.getExpansionLoc(function->getLocation());
    if (sources.isInSystemHeader(place)) return true;
    found_.push_back(describer_.describe(function));
    OptionalFileEntryRef const entry = sources.getFileEntryRefForID(sources.getFileID(place));
    if (entry) found_.back().file = entry->getFileEntry().tryGetRealPathName().str();
    return true;
  }

private:
  ASTContext &context_;
  Describer describer_;
  std::string const &name_;
  std::vector<Callable> &found_;
};

class Action : public ASTFrontendAction {
public:
  Action(std::string const &name, std::vector<Callable> &found) : name_(name), found_(found) {}

  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &compiler, llvm::StringRef) override {
    class Consumer : public ASTConsumer {
    public:
      Consumer(CompilerInstance &compiler, std::string const &name, std::vector<Callable> &found)
          : map_(compiler.getSourceManager(), compiler.getLangOpts(), scope_),
            name_(name),
            found_(found) {}
      void HandleTranslationUnit(ASTContext &context) override {
        Finder(context, map_, name_, found_).TraverseDecl(context.getTranslationUnitDecl());
      }

    private:
      Scope scope_;
      SourceMap map_;
      std::string const &name_;
      std::vector<Callable> &found_;
    };
    return std::make_unique<Consumer>(compiler, name_, found_);
  }

private:
  std::string const &name_;
  std::vector<Callable> &found_;
};

} // namespace

std::vector<Callable> find_callables(Request const &request, std::string const &name) {
  std::vector<Callable> all;
  std::vector<Compilation> const compilations = compilations_of(request);
  for (std::size_t i = 0; i < compilations.size(); ++i) {
    std::string const real = real_source(compilations[i]);
    if (request.exclude.matches(real)) continue;
    if (request.reachable) // a source that defines it has its name
      if (auto const text = llvm::MemoryBuffer::getFile(real); text && !(*text)->getBuffer().contains(name)) continue;
    std::vector<Callable> found;
    IgnoringDiagConsumer ignore;
    IntrusiveRefCntPtr<FileManager> const files(
        new FileManager(FileSystemOptions(), file_system(compilations[i], request, own_disk())));
    tooling::ToolInvocation invocation(command_line(compilations[i]), std::make_unique<Action>(name, found),
                                       files.get());
    invocation.setDiagnosticConsumer(&ignore);
    (void)invocation.run();
    for (Callable &one : found) {
      bool const is_known = std::any_of(all.begin(), all.end(), [&](Callable const &other) {
        return other.file == one.file && other.place.line == one.place.line && other.place.column == one.place.column;
      });
      one.source = i;
      if (!is_known) all.push_back(std::move(one));
    }
  }
  return all;
}

} // namespace symreal::rewrite
