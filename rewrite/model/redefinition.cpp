#include "rewrite/model/redefinition.h"

#include "rewrite/model/plain_declaration.h"
#include "rewrite/source/source_map.h"

#include <algorithm>
#include <map>
#include <set>

namespace symreal::rewrite {
namespace {

using namespace clang;

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

} // namespace

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

  std::string parameters;
  for (ParmVarDecl const *parameter : function->parameters()) {
    std::string const name = name_of(parameter);
    QualType const type = parameter->getType();
    if (!parameters.empty()) parameters += ", ", found.arguments += ", ";
    parameters += needs.written(parameter->getOriginalType(), name);
    found.arguments +=
        type->isRValueReferenceType() ? "static_cast<" + needs.written(type, "") + ">(" + name + ")" : name;
  }
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

} // namespace symreal::rewrite
