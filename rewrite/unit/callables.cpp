#include "rewrite/unit/callables.h"

#include "rewrite/model/scalar_state.h"
#include "rewrite/model/signature.h"
#include "rewrite/source/source_map.h"
#include "rewrite/source/walk.h"
#include "rewrite/unit/collect_source.h"

#include <algorithm>

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

QualType without_const(ASTContext &context, QualType type) {
  if (auto const *array = context.getAsConstantArrayType(type))
    return context.getConstantArrayType(without_const(context, array->getElementType()), array->getSize(), nullptr,
                                        ArraySizeModifier::Normal, 0);
  return type.getUnqualifiedType();
}

// Whether a program cannot declare an object of the type: functions, text and unknown types.
bool is_opaque(QualType type) {
  return type->isFunctionType() || type->isVoidType() || type->isIncompleteType() || type->isAnyCharacterType();
}

// Public members: numbers, arrays of them element by element, and containers, which are filled as a whole.
class PublicMembers {
public:
  explicit PublicMembers(ASTContext &context) : context_(context) {}

  void find(QualType type, CallParameter &to) {
    RecordType const *record = type->getAs<RecordType>();
    RecordDecl const *definition = record ? record->getDecl()->getDefinition() : nullptr;
    auto const *in_cxx = dyn_cast_or_null<CXXRecordDecl>(definition);
    if (definition && !(in_cxx && has_elements(in_cxx))) members(definition, "");
    to.members = std::move(found_);
    to.other_members = std::move(others_);
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
      if (in_cxx && has_elements(in_cxx)) {
        found_.push_back(path);
        if (has_method(in_cxx, "resize", 1)) others_.push_back({path, Kind::container, ""});
      } else
        members(record->getDecl()->getDefinition(), path);
    } else if (type->isIntegralOrEnumerationType()) {
      others_.push_back({path, Kind::integer, ""});
    } else if (type->isPointerType() && !is_opaque(type->getPointeeType()) &&
               is_default_constructible(context_.getBaseElementType(type->getPointeeType()))) {
      others_.push_back(
          {path, Kind::pointer, declared(without_const(context_, type->getPointeeType()), "$[#]", context_)});
    }
  }

  using Kind = CallParameter::Member::Kind;
  ASTContext &context_;
  std::vector<std::string> found_;
  std::vector<CallParameter::Member> others_;
};

std::string qualified_name(FunctionDecl const *function, bool with_inline = false) {
  PrintingPolicy policy(function->getASTContext().getLangOpts());
  if (with_inline) policy.SuppressInlineNamespace = false;
  std::string name;
  llvm::raw_string_ostream out(name);
  function->printQualifiedName(out, policy);
  for (std::string const unnamed = "(anonymous namespace)::"; name.find(unnamed) != std::string::npos;)
    name.erase(name.find(unnamed), unnamed.size());
  return name;
}

class Describer {
public:
  Describer(ASTContext &context, SourceMap const &map) : context_(context), map_(map) {}

  // `definition`: the pattern of a template's instance, else the function itself.
  Callable describe(FunctionDecl const *function, FunctionDecl const *definition) const {
    Callable result;
    result.name = function->getNameAsString();
    result.qualified = qualified_name(function);
    result.with_inline = qualified_name(function, /*with_inline=*/true);
    result.is_c = !context_.getLangOpts().CPlusPlus;
    SourceManager const &sources = context_.getSourceManager();
    SourceLocation const place = sources.getExpansionLoc(definition->getLocation());
    result.place = map_.place(definition->getLocation());
    if (OptionalFileEntryRef const entry = sources.getFileEntryRefForID(sources.getFileID(place)))
      result.file = entry->getFileEntry().tryGetRealPathName().str();
    std::string types, declared_types, parameters;
    for (ParmVarDecl const *one : function->parameters()) {
      result.parameters.push_back(parameter(one));
      types += (types.empty() ? "" : ", ") + one->getType().getCanonicalType().getAsString(context_.getLangOpts());
      declared_types += (declared_types.empty() ? "" : ", ") + one->getType().getAsString(context_.getLangOpts());
      parameters +=
          (parameters.empty() ? "" : ", ") + declared(one->getOriginalType(), one->getNameAsString(), context_);
    }
    if (definition != function) {
      types.clear();
      for (ParmVarDecl const *one : definition->parameters())
        types += (types.empty() ? "" : ", ") + one->getType().getAsString(context_.getLangOpts());
    }
    result.key = qualified_name(definition) + "(" + types + ")";
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
    if (type->isArrayType())
      type = context_.getBaseElementType(type).isConstQualified() ? without_const(context_, type) : type;
    to.variable = declared(type, "$", context_);
    to.default_constructible = is_default_constructible(type);
    CXXRecordDecl const *record = type->getAsCXXRecordDecl();
    if (type->isSpecificBuiltinType(BuiltinType::Double))
      to.kind = Kind::number;
    else if (type->isArithmeticType() || type->isEnumeralType()) {
      to.kind = Kind::integer;
      to.is_integral = type->isIntegerType() && !type->isEnumeralType() && !type->isBooleanType();
      to.holds_scalar = ScalarState::is_scalar(type);
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
      PublicMembers(context_).find(type, to);
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

  void point(CallParameter &to, QualType pointee) const {
    if (is_opaque(pointee)) return;
    to.kind = CallParameter::Kind::pointer;
    QualType const element = without_const(context_, pointee);
    to.pointee = declared(element, "$[#]", context_);
    if (auto const *inner = element->getAs<PointerType>())
      to.rows = declared(without_const(context_, inner->getPointeeType()), "$[#][#]", context_);
    PublicMembers(context_).find(element, to);
    to.points_to_numbers = !context_.getBaseElementType(element)->isRecordType();
    to.default_constructible = is_default_constructible(context_.getBaseElementType(element));
  }

  ASTContext &context_;
  SourceMap const &map_;
};

constexpr char const *address_variable = "symreal_address";

class Finder : public Walk {
public:
  Finder(ASTContext &context, SourceMap const &map, std::string const &name, std::vector<Callable> &found)
      : context_(context),
        describer_(context, map),
        name_(name),
        found_(found) {}

  bool VisitFunctionDecl(FunctionDecl *function) override {
    if (!function->doesThisDeclarationHaveABody() || function->isTemplated() || function->isImplicit()) return true;
    if (!is_called(function, name_)) return true;
    if (context_.getSourceManager().isInSystemHeader(function->getLocation())) return true;
    found_.push_back(describer_.describe(function, function));
    return true;
  }

  // Finds the instance whose address initialises the inserted variable.
  bool VisitVarDecl(VarDecl *variable) override {
    if (!variable->getIdentifier() || variable->getName() != address_variable || !variable->getInit()) return true;
    Expr const *const address = variable->getInit()->IgnoreParenImpCasts();
    auto const *unary = dyn_cast<UnaryOperator>(address);
    auto const *reference = dyn_cast<DeclRefExpr>(unary ? unary->getSubExpr()->IgnoreParenImpCasts() : address);
    auto const *function = reference ? dyn_cast<FunctionDecl>(reference->getDecl()) : nullptr;
    if (!function) return true;
    FunctionDecl const *definition = function->getTemplateInstantiationPattern();
    if (!definition) definition = function->getDefinition();
    if (definition && definition->isDefined(definition)) found_.push_back(describer_.describe(function, definition));
    return true;
  }

private:
  static bool is_called(FunctionDecl const *function, std::string const &name) {
    if (function->getDeclName().isIdentifier()) return function->getName() == name;
    return isa<CXXConstructorDecl, CXXDestructorDecl>(function) ? false : function->getNameAsString() == name;
  }

  ASTContext &context_;
  Describer describer_;
  std::string const &name_;
  std::vector<Callable> &found_;
};

} // namespace

// Callables with this name in one source.
static std::vector<Callable> callables_of(Compilation const &source, Request const &request, std::string const &name) {
  std::vector<Callable> found;
  visit_tree(source, file_system(source, request, own_disk()), Scope(), [&](ASTContext &context, SourceMap const &map) {
    Finder(context, map, name, found).TraverseDecl(context.getTranslationUnitDecl());
  });
  return found;
}

// Calls `visit` with the compilations that may have the word, and their numbers.
template <class Visit> static void each_source(Request const &request, std::string const &word, Visit visit) {
  std::vector<Compilation> const compilations = compilations_of(request);
  for (std::size_t i = 0; i < compilations.size(); ++i) {
    std::string const real = real_source(compilations[i]);
    if (request.exclude.matches(real)) continue;
    if (request.reachable)
      if (auto const text = llvm::MemoryBuffer::getFile(real); text && !(*text)->getBuffer().contains(word)) continue;
    visit(compilations[i], i);
  }
}

std::vector<Callable> find_callables(Request const &request, std::string const &name) {
  std::vector<Callable> all;
  std::string const word = name.starts_with("operator") ? "operator" : name; // a source that defines it has it
  each_source(request, word, [&](Compilation const &source, std::size_t number) {
    for (Callable &one : callables_of(source, request, name)) {
      bool const is_known = std::any_of(all.begin(), all.end(), [&](Callable const &other) {
        return other.file == one.file && other.place.line == one.place.line && other.place.column == one.place.column;
      });
      one.source = number;
      if (!is_known) all.push_back(std::move(one));
    }
  });
  return all;
}

std::vector<Callable> find_instance(Request const &request, std::string const &word, std::string const &address) {
  std::vector<Callable> all;
  each_source(request, word, [&](Compilation source, std::size_t number) {
    if (!all.empty()) return;
    llvm::StringRef const ending = llvm::sys::path::extension(source.source);
    std::string const file = llvm::sys::path::filename(source.source).str();
    std::string const real = real_source(source) + ".symreal-address" + ending.str();
    Request beside = request;
    beside.texts.push_back({real, "#include \"" + file +
                                      "\"\ntemplate <class T> struct symreal_plain { typedef T type; };\n" +
                                      "template <class T> struct symreal_plain<T &> { typedef T type; };\n" +
                                      "template <class T> struct symreal_plain<T &&> { typedef T type; };\n" + "auto " +
                                      address_variable + " = " + address + ";\n"});
    source.source = real;
    all = callables_of(source, beside, "");
    for (Callable &one : all) one.source = number;
  });
  return all;
}

} // namespace symreal::rewrite
