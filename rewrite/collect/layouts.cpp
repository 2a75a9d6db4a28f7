#include "rewrite/collect/walks.h"

#include "rewrite/source/walk.h"

#include <clang/AST/RecordLayout.h>

namespace symreal::rewrite {
namespace {

using namespace clang;

class Layouts : public Walk {
public:
  Layouts(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts)
      : context_(context),
        map_(map),
        reals_(reals),
        facts_(facts) {}

  bool shouldVisitTemplateInstantiations() const override { return true; }

  bool VisitRecordDecl(RecordDecl *record) override {
    if (!record->isThisDeclarationADefinition() || record->isDependentContext() || record->isInvalidDecl() ||
        !map_.in_roots(record->getLocation()) || !reals_.carries_real(context_.getRecordType(record)))
      return true;
    bool needs_look = has_layout_attribute(record);
    if (auto const *derived = dyn_cast<CXXRecordDecl>(record))
      for (CXXBaseSpecifier const &base : derived->bases())
        if (auto const *shared = base.getType()->getAsCXXRecordDecl(); shared && !shared->isEmpty()) {
          needs_look = true;
          if (!base.isVirtual()) keep_padding(shared, record);
        }
    for (FieldDecl const *field : record->fields()) {
      needs_look |= has_layout_attribute(field);
      if (auto const *shared = field->getType()->getAsCXXRecordDecl(); shared && field->hasAttr<NoUniqueAddressAttr>())
        keep_padding(shared, record);
    }
    if (needs_look) write_down(record);
    return true;
  }

private:
  static bool has_layout_attribute(Decl const *declaration) {
    return declaration->hasAttr<PackedAttr>() || declaration->hasAttr<AlignedAttr>() ||
           declaration->hasAttr<MaxFieldAlignmentAttr>() || declaration->hasAttr<NoUniqueAddressAttr>();
  }

  // A derived class's next member begins behind the padding of a POD base, but within that of another class; a REAL
  // among its members makes the base non-POD.
  void keep_padding(CXXRecordDecl const *shared, RecordDecl const *user) {
    if (!shared->isPOD() || !reals_.carries_real(context_.getRecordType(shared)) || shared->isUnion()) return;
    ASTRecordLayout const &layout = context_.getASTRecordLayout(shared);
    CharUnits const end = end_of_members(shared);
    std::int64_t const padding = (layout.getSize() - end).getQuantity();
    if (padding == 0) return;
    SourceLocation const brace = shared->getBraceRange().getEnd();
    std::optional<Span> const span = map_.token(brace);
    constexpr std::int64_t container = 8; // of a bit-field
    if (isa<ClassTemplateSpecializationDecl>(shared) || !span || brace.isMacroID() || padding >= container)
      add_diagnostic(facts_, {DiagnosticId::class_layout, map_.place(user->getLocation()),
                              "what follows '" + shared->getQualifiedNameAsString() + "' in '" +
                                  user->getQualifiedNameAsString() + "' would begin in its padding"});
    else
      facts_.wraps.insert({*span, Use::padding, std::to_string(padding)});
  }

  CharUnits end_of_members(CXXRecordDecl const *record) const {
    CharUnits end = CharUnits::Zero();
    ASTRecordLayout const &layout = context_.getASTRecordLayout(record);
    for (FieldDecl const *field : record->fields()) {
      std::uint64_t const first = layout.getFieldOffset(field->getFieldIndex());
      std::uint64_t const size =
          field->isBitField() ? field->getBitWidthValue(context_) : context_.getTypeSize(field->getType());
      end = std::max(
          end, context_.toCharUnitsFromBits(static_cast<std::int64_t>(first + size + context_.getCharWidth() - 1)));
    }
    return end;
  }

  void write_down(RecordDecl const *record) {
    SourceLocation const brace = record->getBraceRange().getBegin();
    if (is_instance(record)) return; // one text for all of them
    std::optional<Span> const span = map_.token(brace);
    bool const has_name = record->getIdentifier() || record->getTypedefNameForAnonDecl();
    if (!has_name || !span || brace.isMacroID()) return;
    ASTRecordLayout const &layout = context_.getASTRecordLayout(record);
    std::string text = record->isClass() ? "private" : "public";
    text += ", sizeof(symreal_class) == " + std::to_string(layout.getSize().getQuantity());
    text += " && alignof(symreal_class) == " + std::to_string(layout.getAlignment().getQuantity());
    for (FieldDecl const *field : record->fields()) {
      if (!field->getIdentifier() || field->isBitField() || field->getType()->isReferenceType()) continue;
      CharUnits const offset =
          context_.toCharUnitsFromBits(static_cast<std::int64_t>(layout.getFieldOffset(field->getFieldIndex())));
      text += " && __builtin_offsetof(symreal_class, " + field->getNameAsString() +
              ") == " + std::to_string(offset.getQuantity());
    }
    facts_.wraps.insert({*span, Use::layout, text});
  }

  static bool is_instance(RecordDecl const *record) {
    for (DeclContext const *context = record; context; context = context->getParent()) {
      auto const *function = dyn_cast<FunctionDecl>(context);
      if (isa<ClassTemplateSpecializationDecl>(context) || (function && function->isTemplateInstantiation()))
        return true;
    }
    return false;
  }

  ASTContext &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Facts &facts_;
};

} // namespace

void collect_layouts(ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts) {
  Layouts(context, map, reals, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
