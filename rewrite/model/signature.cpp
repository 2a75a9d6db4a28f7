#include "rewrite/model/signature.h"

#include "rewrite/model/storage.h"
#include "rewrite/source/source_map.h"

#include <algorithm>
#include <clang/AST/QualTypeNames.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>

namespace symreal::rewrite {
using namespace clang;

namespace {

// The parameters of a function as a declaration and a call have them. Unnamed ones get a name.
struct Parameters {
  std::string declared, passed;
};

Parameters parameters_of(FunctionDecl const *function) {
  ASTContext const &context = function->getASTContext();
  Parameters all;
  for (ParmVarDecl const *parameter : function->parameters()) {
    std::string name = parameter->getNameAsString();
    if (name.empty()) name = "symreal_argument_" + std::to_string(parameter->getFunctionScopeIndex());
    QualType const type = parameter->getType();
    if (!all.declared.empty()) all.declared += ", ", all.passed += ", ";
    all.declared += declared(parameter->getOriginalType(), name, context);
    all.passed +=
        type->isRValueReferenceType() ? "static_cast<" + declared(type, "", context) + ">(" + name + ")" : name;
  }
  return all;
}

// Another function of that name.
bool is_overloaded(FunctionDecl const *function) {
  for (NamedDecl const *other : function->getDeclContext()->getRedeclContext()->lookup(function->getDeclName()))
    if (isa<FunctionDecl, FunctionTemplateDecl>(other) && other->getCanonicalDecl() != function->getCanonicalDecl())
      return true;
  return false;
}

// Reason why no other file can define the function.
std::string obstacle_of(FunctionDecl const *function) {
  if (function->isTemplated() || function->getPrimaryTemplate() || function->getTemplateInstantiationPattern())
    return "it is a template, which each source instantiates for itself";
  if (isa<CXXConstructorDecl, CXXDestructorDecl>(function)) return "it is a constructor or destructor";
  if (function->isVariadic()) return "it has variable arguments";
  if (!function->isExternallyVisible() || function->getFormalLinkage() == Linkage::Internal)
    return "it is static or in an unnamed namespace, so only its own file can call it";
  if (function->isInlined() && function->getASTContext().getLangOpts().CPlusPlus)
    return "it is inline, so each source that calls it has its own copy; define it in one source";
  if (function->isInlined()) return "it is inline";
  for (DeclContext const *scope = function->getDeclContext(); scope; scope = scope->getParent())
    if (isa<FunctionDecl>(scope)) return "its class is local to a function";
  return {};
}

class Needs {
public:
  Needs(FunctionDecl const *function, Redefinition &found)
      : function_(function),
        sources_(function->getASTContext().getSourceManager()),
        home_(file_of(function->getLocation())),
        found_(found) {}

  // Whether a header declares the function, so that its outermost scope need not be opened.
  bool declared_in_header() {
    for (FunctionDecl const *one : function_->redecls())
      if (file_of(one->getLocation()) != home_ && include(one->getLocation())) return true;
    return false;
  }

  void types() {
    type(function_->getReturnType());
    for (ParmVarDecl const *parameter : function_->parameters()) type(parameter->getType());
    if (auto const *method = dyn_cast<CXXMethodDecl>(function_)) record(method->getParent());
  }

  void name(NamedItem const &item) {
    ValueDecl const *value = item.declaration;
    if (isa<ParmVarDecl, FieldDecl>(value)) return;
    auto const *variable = dyn_cast<VarDecl>(value);
    if (variable && variable->isStaticDataMember()) return;
    for (Decl const *one : value->redecls())
      if (file_of(one->getLocation()) != home_ && include(one->getLocation())) return;
    if (variable && variable->isExternallyVisible() && variable->getFormalLinkage() == Linkage::External) {
      type(variable->getType());
      declare(variable);
    } else
      miss(item.name);
  }

  std::vector<Include> includes() const {
    std::vector<Include> all;
    for (auto const &[offset, one] : includes_)
      if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    for (std::string const &name : standard_)
      if (Include const one{name, ""}; std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
    return all;
  }

  std::string written(QualType type, std::string name) const {
    return declared(type, std::move(name), function_->getASTContext());
  }

private:
  FileID file_of(SourceLocation location) const { return sources_.getFileID(sources_.getExpansionLoc(location)); }

  // Adds the #include of the function's own file that leads to the location. False without one.
  bool include(SourceLocation location) {
    FileID file = file_of(location);
    while (file.isValid()) {
      SourceLocation const from = sources_.getIncludeLoc(file);
      if (from.isInvalid()) return false;
      FileID const includer = sources_.getFileID(from);
      if (includer == home_ || (includer == sources_.getMainFileID() && home_ != includer)) {
        add(file, from);
        return true;
      }
      file = includer;
    }
    return false;
  }

  void add(FileID file, SourceLocation from) {
    auto const [includer, offset] = sources_.getDecomposedLoc(from);
    llvm::StringRef line = sources_.getBufferData(includer).substr(offset).split('\n').first;
    std::size_t const open = line.find_first_of("\"<");
    std::size_t const close = open == line.npos ? open : line.find_first_of("\">", open + 1);
    std::string const real = name_of_file(file);
    std::string name =
        close == line.npos ? "\"" + real + "\"" : line.substr(open, close + 1 - open).str(); // a macro says which
    llvm::SmallString<256> beside(llvm::sys::path::parent_path(name_of_file(includer)));
    llvm::sys::path::append(beside, llvm::StringRef(name).substr(1, name.size() - 2));
    bool const is_beside = name[0] == '"' && real_path(beside.str().str()) == real;
    includes_.emplace(offset, Include{name, is_beside ? real : ""});
  }

  std::string name_of_file(FileID file) const {
    OptionalFileEntryRef const entry = sources_.getFileEntryRefForID(file);
    return entry ? real_path(entry->getFileEntry().tryGetRealPathName().empty()
                                 ? entry->getName().str()
                                 : entry->getFileEntry().tryGetRealPathName().str())
                 : "";
  }

  void miss(std::string const &name) {
    if (std::find(found_.missing.begin(), found_.missing.end(), name) == found_.missing.end())
      found_.missing.push_back(name);
  }

  void declaration(NamedDecl const *one) {
    if (file_of(one->getLocation()) == home_)
      miss(one->getQualifiedNameAsString());
    else
      include(one->getLocation());
  }

  // Adds the standard library's header of a class: this compiler may have got the class through another header.
  bool include_standard(TagDecl const *tag) {
    static std::map<llvm::StringRef, llvm::StringRef> const headers = {
        {"vector", "vector"},     {"array", "array"},
        {"complex", "complex"},   {"basic_string", "string"},
        {"pair", "utility"},      {"function", "functional"},
        {"tuple", "tuple"},       {"optional", "optional"},
        {"map", "map"},           {"set", "set"},
        {"deque", "deque"},       {"list", "list"},
        {"valarray", "valarray"}, {"span", "span"},
        {"shared_ptr", "memory"}, {"unique_ptr", "memory"}};
    auto const header = tag->isInStdNamespace() && tag->getIdentifier() ? headers.find(tag->getName()) : headers.end();
    if (header == headers.end()) return false;
    standard_.insert("<" + header->second.str() + ">");
    return true;
  }

  void record(TagDecl const *tag) {
    if (TagDecl const *definition = tag->getDefinition()) tag = definition;
    if (!known_.insert(tag).second) return;
    if (auto const *special = dyn_cast<ClassTemplateSpecializationDecl>(tag)) {
      for (TemplateArgument const &one : special->getTemplateArgs().asArray())
        if (one.getKind() == TemplateArgument::Type) type(one.getAsType());
      if (!include_standard(tag)) declaration(special->getSpecializedTemplate());
    } else if (tag->getIdentifier() || tag->getTypedefNameForAnonDecl())
      declaration(tag);
  }

  void type(QualType of) {
    auto const *alias = of->getAs<TypedefType>();
    if (alias && !alias->getDecl()->isInStdNamespace()) declaration(alias->getDecl());
    if (auto const *pointer = of->getAs<PointerType>()) return type(pointer->getPointeeType());
    if (auto const *reference = of->getAs<ReferenceType>()) return type(reference->getPointeeType());
    if (auto const *array = function_->getASTContext().getAsArrayType(of)) return type(array->getElementType());
    if (auto const *prototype = of->getAs<FunctionProtoType>()) {
      type(prototype->getReturnType());
      for (QualType const parameter : prototype->param_types()) type(parameter);
    }
    if (TagDecl const *tag = of->getAsTagDecl()) record(tag);
  }

  void declare(VarDecl const *variable) {
    std::string text = "extern " + written(variable->getType(), variable->getName().str()) + ";";
    for (DeclContext const *scope = variable->getDeclContext(); scope; scope = scope->getParent())
      if (auto const *space = dyn_cast<NamespaceDecl>(scope))
        text = "namespace " + space->getName().str() + " { " + text + " }";
    if (variable->isExternC() && variable->getASTContext().getLangOpts().CPlusPlus)
      text = "extern \"C\" { " + text + " }";
    auto &all = found_.declarations;
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
  }

  FunctionDecl const *function_;
  SourceManager const &sources_;
  FileID home_;
  Redefinition &found_;
  std::map<unsigned, Include> includes_; // by the place in the file
  std::set<TagDecl const *> known_;
  std::set<std::string> standard_;
};

// Qualifiers behind the parameters of a definition.
std::string qualifiers(FunctionDecl const *function) {
  std::string text;
  if (auto const *method = dyn_cast<CXXMethodDecl>(function)) {
    if (method->isConst()) text += " const";
    if (method->isVolatile()) text += " volatile";
    if (method->getRefQualifier() == RQ_LValue) text += " &";
    if (method->getRefQualifier() == RQ_RValue) text += " &&";
  }
  auto const *type = function->getType()->getAs<FunctionProtoType>();
  if (!type || !type->isNothrow()) return text;
  bool const is_written = function->getExceptionSpecType() != EST_None;
  return is_written ? text + (type->getExceptionSpecType() == EST_DynamicNone ? " throw()" : " noexcept") : text;
}

// The place where the numbers of an item lie.
enum class Location {
  own,      // in a variable, or in a parameter that is passed by value
  object,   // in an object that the caller names
  elsewhere // behind a pointer, or where a view looks
};

struct Where {
  Location location = Location::elsewhere;
  bool is_parameter = false; // its own memory
  bool is_restricted = false;
  bool is_in_rows = false;
};

Where where_of(PlacedItem const &item) {
  Where where;
  if (item.base_type.isNull()) return where;
  bool const is_through = item.base.starts_with("*") || item.base.find("->") != item.base.npos;
  bool const is_pointer = item.base_type->isPointerType();
  QualType const root = item.root ? item.root->getType() : QualType();
  bool const is_plain_root = !root.isNull() && item.base == item.root_name;
  where.is_restricted = !root.isNull() && root.isRestrictQualified() && (is_plain_root || is_through);
  if (item.sections > 1) {
    QualType const rows = is_pointer                      ? item.base_type->getPointeeType()
                          : item.base_type->isArrayType() ? item.base_type->getAsArrayTypeUnsafe()->getElementType()
                                                          : QualType();
    where.is_in_rows = rows.isNull() || !rows->isArrayType();
  }
  if (is_pointer || Storage::is_view(item.base_type)) return where;
  where.location = Location::object;
  bool const is_variable = item.root && isa<VarDecl>(item.root) && !root->isReferenceType();
  if (is_variable && !is_through) {
    bool const is_decayed = isa<ParmVarDecl>(item.root) && root->isPointerType(); // double a[3]
    if (is_decayed) return where.location = Location::elsewhere, where;
    where.location = Location::own;
    where.is_parameter = isa<ParmVarDecl>(item.root);
  }
  return where;
}

bool may_meet(PlacedItem const &a, PlacedItem const &b) {
  Where const first = where_of(a), second = where_of(b);
  if (a.base == b.base || first.is_restricted || second.is_restricted) return false;
  if (first.is_parameter || second.is_parameter) return false;
  if (first.location == Location::own && second.location == Location::own) return false;
  bool const are_named = first.location != Location::elsewhere && second.location != Location::elsewhere;
  return !(are_named && a.root_name == b.root_name);
}

// The parameter that an item is, or points to.
ParmVarDecl const *parameter_of(PlacedItem const &item) {
  bool const is_whole = item.base == item.root_name || item.base == "*" + item.root_name;
  return is_whole ? dyn_cast_or_null<ParmVarDecl>(item.root) : nullptr;
}

bool is_callable_by_name(FunctionDecl const *function) {
  if (!function->getDeclName().isIdentifier() || function->isTemplated() || function->isConstexpr() ||
      function->isVariadic() || isa<CXXConstructorDecl>(function))
    return false;
  auto const named = function->getDeclContext()->getRedeclContext()->lookup(function->getDeclName());
  if (std::distance(named.begin(), named.end()) != 1) return false;
  return llvm::all_of(function->parameters(), [](ParmVarDecl const *one) {
    QualType const type = one->getType();
    CXXRecordDecl const *record = type->getAsCXXRecordDecl();
    return one->getIdentifier() && !type->isRValueReferenceType() && (!record || record->isTriviallyCopyable());
  });
}

std::string call_with(FunctionDecl const *function, ParmVarDecl const *replaced, ParmVarDecl const *by) {
  std::vector<std::string> arguments;
  for (ParmVarDecl const *one : function->parameters())
    arguments.push_back((one == replaced ? by : one)->getNameAsString());
  return fmt::format("return {}({});", function->getNameAsString(), fmt::join(arguments, ", "));
}

void bring_together(FunctionDecl const *function, PlacedItem const &a, PlacedItem const &b, Overlap &overlap) {
  ParmVarDecl const *first = parameter_of(a), *second = parameter_of(b);
  if (!first || !second) return;
  QualType const one = first->getType(), other = second->getType();
  if (one->isPointerType() && other->isPointerType()) {
    auto const copy = [](ParmVarDecl const *to, ParmVarDecl const *from) {
      return fmt::format("__builtin_memcpy((void *)&{0}, (void const *)&{1}, sizeof {0});", to->getNameAsString(),
                         from->getNameAsString());
    };
    overlap.first_there = copy(first, second);
    overlap.second_there = copy(second, first);
  }
  QualType const referred = one.getNonReferenceType(), another = other.getNonReferenceType();
  bool const is_same =
      referred.getCanonicalType().getUnqualifiedType() == another.getCanonicalType().getUnqualifiedType();
  if (!one->isLValueReferenceType() || !other->isLValueReferenceType() || !is_same || !is_callable_by_name(function))
    return;
  overlap.calls = true;
  overlap.first_there = another.isConstQualified() && !referred.isConstQualified() ? call_with(function, second, first)
                                                                                   : call_with(function, first, second);
  overlap.second_there = overlap.first_there;
}

} // namespace

std::string type_text(QualType type, ASTContext const &context) {
  PrintingPolicy policy(context.getLangOpts());
  policy.SuppressUnwrittenScope = true;
  policy.SuppressTagKeyword = true;
  return TypeName::getFullyQualifiedName(type, context, policy);
}

std::string declared(QualType type, std::string name, ASTContext const &context) {
  TypeName::getFullyQualifiedType(type, context).getAsStringInternal(name, PrintingPolicy(context.getLangOpts()));
  return name;
}

std::optional<Signature> plain_declaration(FunctionDecl const *function, LangOptions const &language) {
  bool const is_global = function->getDeclContext()->getRedeclContext()->isTranslationUnit();
  if (!is_global || function->isVariadic() || function->isTemplated() || function->getPrimaryTemplate() ||
      !function->getDeclName().isIdentifier() || is_overloaded(function))
    return {};
  ASTContext const &context = function->getASTContext();
  auto [parameters, arguments] = parameters_of(function);
  if (parameters.empty() && !language.CPlusPlus) parameters = "void";
  std::string text = declared(function->getReturnType(), function->getNameAsString() + "(" + parameters + ")", context);
  Signature signature{text, arguments, !function->getReturnType()->isVoidType()};
  if (!language.CPlusPlus) return signature;
  auto const *type = function->getType()->getAs<FunctionProtoType>();
  if (type && type->getExceptionSpecType() == EST_BasicNoexcept) signature.declaration += " noexcept";
  if (function->isExternC()) signature.declaration.insert(0, "extern \"C\" ");
  return signature;
}

Redefinition redefinition(FunctionDecl const *function, std::vector<NamedItem> const &names) {
  Redefinition found;
  found.qualified = function->getQualifiedNameAsString();
  for (NamedItem const &one : names) {
    auto const *variable = dyn_cast<VarDecl>(one.declaration);
    bool const varies = isa<FieldDecl>(one.declaration) || (variable && !variable->getType().isConstQualified());
    if (varies || isa<ParmVarDecl>(one.declaration)) found.varying.push_back(one.name);
  }
  found.obstacle = obstacle_of(function);
  if (!found.obstacle.empty()) return found;
  bool const is_cxx = function->getASTContext().getLangOpts().CPlusPlus;
  Needs needs(function, found);
  bool const is_declared = needs.declared_in_header();
  needs.types();
  for (NamedItem const &one : names) needs.name(one);
  found.includes = needs.includes();

  auto [parameters, arguments] = parameters_of(function);
  found.arguments = std::move(arguments);
  found.parameters = parameters;
  found.returned = needs.written(function->getReturnType(), "");
  auto const *method = dyn_cast<CXXMethodDecl>(function);
  found.has_this = method && !method->isStatic();
  if (found.has_this)
    found.parameters =
        needs.written(method->getThisType(), "symreal_self") + (parameters.empty() ? "" : ", ") + parameters;
  if (parameters.empty() && !is_cxx) parameters = "void";

  bool const is_member = method != nullptr;
  std::string const name = is_cxx && (is_declared || is_member) ? found.qualified : function->getNameAsString();
  found.head = needs.written(function->getReturnType(), name + "(" + parameters + ")") + qualifiers(function);
  if (is_cxx && !is_declared && function->isExternC()) found.head.insert(0, "extern \"C\" ");
  if (!is_declared && !is_member)
    for (DeclContext const *scope = function->getDeclContext(); scope; scope = scope->getParent())
      if (auto const *space = dyn_cast<NamespaceDecl>(scope))
        found.namespaces.insert(found.namespaces.begin(),
                                (space->isInline() ? "inline namespace " : "namespace ") + space->getName().str());
  ASTNameGenerator mangler(function->getASTContext());
  found.mangled = mangler.getName(function);
  return found;
}

std::vector<Overlap> possible_overlaps(FunctionDecl const *function, std::vector<PlacedItem> const &items) {
  std::vector<Overlap> found;
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      PlacedItem const &a = items[j], &b = items[i];
      bool const is_known = std::ranges::any_of(found, [&](Overlap const &one) {
        return (one.first == a.label && one.second == b.label) || (one.first == b.label && one.second == a.label);
      });
      if (is_known || (!a.is_output && !b.is_output) || !may_meet(a, b)) continue;
      Overlap overlap{a.label, b.label, where_of(a).is_in_rows, where_of(b).is_in_rows, {}, {}, false};
      bring_together(function, a, b, overlap);
      found.push_back(std::move(overlap));
    }
  return found;
}

} // namespace symreal::rewrite
