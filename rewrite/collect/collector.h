// Collector of facts: one member for each kind of syntax that the visitor meets. Members edit nothing.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/effects.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/model/storage.h"
#include "rewrite/model/surroundings.h"
#include "rewrite/model/written_first.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <functional>
#include <vector>

namespace symreal::rewrite {

class Collector {
public:
  Collector(clang::ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
            Surroundings const &surroundings, Facts &facts)
      : context_(context),
        map_(map),
        reals_(reals),
        scalars_(scalars),
        surroundings_(surroundings),
        storage_(reals),
        facts_(facts) {}

  // Defers a handler that depends on facts from others about the same expression until all are collected, so that
  // handlers may be called in any order. `finish` runs the deferred handlers.
  void later(std::function<void()> handler) { waiting_.push_back({instance_, std::move(handler)}); }
  void finish();

  // Types (types.cpp).
  void builtin_type(clang::BuiltinTypeLoc type, Passive passive);
  void complex_type(clang::ComplexTypeLoc type);
  void constrained(clang::TemplateParameterList const *parameters);
  // A name outside the roots for a type with double in it: Eigen's Vector3d, double_t.
  void typedef_name(clang::TypedefNameDecl const *declaration, clang::SourceLocation name, bool qualified,
                    bool within_type);

  // Calls (calls.cpp).
  void call(clang::CallExpr const *call);
  void symbolic_main(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void annotated_structure(clang::Expr const *argument);
  void construction(clang::CXXConstructExpr const *construction);
  void builtin(clang::DeclRefExpr const *name);
  void function_value(clang::DeclRefExpr const *name);
  void dependent_variadic_call(clang::CallExpr const *call);
  void argument_list(clang::FunctionDecl const *function);
  void converting_construction(clang::CXXConstructExpr const *construction);
  void converted_operand(clang::UnaryOperator const *operation);
  void removed_member(clang::CXXMemberCallExpr const *call);
  void converted_by_library(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void kept_callable(clang::CXXConstructExpr const *construction);
  void complex_literal(clang::UserDefinedLiteral const *literal);
  void converted_operands(clang::BinaryOperator const *operation, clang::DeclContext const *from);

  // Facts that only an instantiation shows (instances.cpp).
  void set_instance(std::optional<Note> instance) { instance_ = std::move(instance); }
  void instantiated_call(clang::CallExpr const *call);
  void instantiated_construction(clang::CXXConstructExpr const *construction);
  void instantiated_value(clang::Expr const *value);
  void instantiated_read(clang::Expr const *value);

  // Everything else (expressions.cpp).
  // Most implicit casts read a variable or take an address.
  static bool may_convert(clang::ImplicitCastExpr const *cast) {
    return cast->getCastKind() != clang::CK_LValueToRValue && cast->getCastKind() != clang::CK_ArrayToPointerDecay &&
           cast->getCastKind() != clang::CK_FunctionToPointerDecay;
  }
  void implicit_cast(clang::ImplicitCastExpr const *cast, bool decides);
  void explicit_cast(clang::ExplicitCastExpr const *cast);
  void compound_assignment(clang::CompoundAssignOperator const *assignment);
  void choice(clang::ConditionalOperator const *choice);
  void constant_initializer(clang::Expr const *initializer, bool is_deduced = false);
  // Constant objects of doubles where objects of REALs are taken (constants.cpp). `function`: the one being visited.
  void set_function(clang::FunctionDecl const *const *function) { function_ = function; }
  void constant_object(clang::Expr const *value, bool is_in_constant = false);
  void constants_handed(clang::FunctionDecl const *function, llvm::ArrayRef<clang::Expr const *> arguments);
  bool constant_result_of(clang::Expr const *initializer);
  void constant_initializer_of(clang::VarDecl const *variable);
  void constant_arguments(clang::CallExpr const *dependent);
  void constant_elements(clang::CXXForRangeStmt const *loop);
  void constant_result(clang::ReturnStmt const *statement, clang::FunctionDecl const *function);
  void constant_operand(clang::BinaryOperator const *operation);
  void deduced_variable(clang::VarDecl const *variable);
  void deduced_return(clang::FunctionDecl const *function);
  void deduced_elements(clang::Expr const *initializer);
  // A function whose declaration text is part of the program: __PRETTY_FUNCTION__, which assert prints.
  void printed_signature(clang::FunctionDecl const *function);
  // The original name of a type (types.cpp).
  void type_asked(clang::CXXTypeidExpr const *type);
  void type_asked(clang::CXXMemberCallExpr const *call);
  void signature_asked(clang::PredefinedExpr const *name, clang::FunctionDecl const *function);
  // Constructs of C that C++ does not allow (c.cpp).
  void c_declaration(clang::NamedDecl const *declaration);
  bool is_pointer_of_c(clang::ImplicitCastExpr const *cast) const;
  void c_search(clang::CallExpr const *call);
  void c_choice(clang::ConditionalOperator const *choice);
  void c_prototype(clang::FunctionDecl const *function);
  void c_call(clang::CallExpr const *call);
  void c_arguments(clang::CallExpr const *call);
  void c_generic_call(clang::CallExpr const *call);
  void kind_asked(clang::CallExpr const *call);

  // Expressions of C whose type differs in C++ (c_types.cpp).
  void c_operation(clang::BinaryOperator const *operation);
  void c_operation(clang::UnaryOperator const *operation);
  void c_operand(clang::SourceLocation operation, clang::Expr const *operand);
  void c_type_asked(clang::Expr const *operand, bool is_size);
  void c_control(clang::Expr const *control);
  void c_literal(clang::IntegerLiteral const *literal);
  clang::QualType counted_as(clang::Expr const *enumeration) const;
  // Bit-fields that are wider than int.
  void c_widths(clang::BinaryOperator const *operation);
  void c_widths(clang::UnaryOperator const *operation);
  void c_widths(clang::ConditionalOperator const *choice);
  // Bit-fields that are narrower than int.
  void narrow_fields(clang::AbstractConditionalOperator const *choice);
  void narrow_fields(clang::BinaryOperator const *operation);

  // File-scope variables of C (c.cpp).
  void tentative_definitions(clang::VarDecl const *variable);
  bool tentative_definition(clang::VarDecl const *variable, bool is_definition);
  bool declare_external(clang::VarDecl const *variable);

  // Constructs without a counterpart (refused.cpp).
  void assembly(clang::GCCAsmStmt const *assembly);
  void designators(clang::InitListExpr const *list);

  // errno and the floating-point environment (library_calls.cpp).
  void environment_of_call(clang::CallExpr const *call);
  void error_read(clang::Expr const *value);
  void error_assigned(clang::BinaryOperator const *assignment);
  // Results of library functions.
  void call_outside(clang::CallExpr const *call);
  void stream_asked(clang::CXXMemberCallExpr const *call);

  // Text that is made of REALs, and text that is read (text.cpp).
  void discarded(clang::Stmt const *statement, clang::FunctionDecl const *function);
  void text_of_call(clang::CallExpr const *call);
  void text_comparison(clang::CXXRewrittenBinaryOperator const *comparison);
  void characters(clang::Expr const *value);
  void characters_of(clang::CXXForRangeStmt const *loop);
  void keeps_text(clang::QualType type);

  // Value-dependent operations, for the report of a scan (expressions.cpp).
  void conversion(clang::CastExpr const *cast);
  void comparison(clang::BinaryOperator const *comparison);

  // Names of numbers (collector.cpp).
  void named_variable(clang::VarDecl const *variable);
  void named_target(clang::BinaryOperator const *assignment);

  // Hidden state (state.cpp, state_calls.cpp).
  void state(clang::VarDecl const *variable, clang::Expr const *reference, bool is_dependent);
  void read(clang::Expr const *value);
  // Uses that depend on an object's class: typeid(*p), dynamic_cast<T *>(p).
  void class_asked(clang::Expr const *object) { decides_by_pointer(object); }
  void reference_member(clang::MemberExpr const *member);
  void made_in_place(clang::CXXNewExpr const *made);
  void assignment(clang::BinaryOperator const *assignment);
  void step(clang::UnaryOperator const *step);
  void related_pointers(clang::BinaryOperator const *operation);
  void dependent_operands(clang::BinaryOperator const *operation);
  void dependent_value(clang::Expr const *value);
  void dependent_call(clang::CallExpr const *call);
  void copied_elements(clang::CXXForRangeStmt const *loop);
  void members(clang::RecordDecl const *record);
  // Bytes of a REAL that are used as something else (bits.cpp).
  void union_member(clang::MemberExpr const *member);
  void pointer_cast(clang::CastExpr const *cast);
  void read_view(clang::Expr const *value);
  void atomic_builtin(clang::AtomicExpr const *call);
  // The operand of sizeof or decltype, or an operand that a concept examines.
  void looked_at(clang::Expr const *operand);
  void erased(clang::Expr const *operand);
  void kept_by_type(clang::FunctionDecl const *function, std::vector<clang::Expr const *> const &arguments);
  void state_of_call(clang::CallExpr const *call);
  void state_of_construction(clang::CXXConstructExpr const *construction);

private:
  bool fill(clang::DesignatedInitExpr const &designated, std::uint64_t index, std::uint64_t &next, bool is_counted);
  bool has_operator(clang::OverloadedOperatorKind kind, clang::DeclContext const *from) const;
  void environment(clang::Expr const *expression, char const *what, std::string const &name);
  void shows(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void formatted(clang::CallExpr const *call, clang::FunctionDecl const *function);
  // `only_looks`: takes the object only, whose characters may be read later.
  void reads_text(clang::SourceLocation reader, clang::Expr const *text, bool only_looks = false);

  void name(llvm::StringRef name, clang::SourceLocation begin, clang::SourceLocation end);

  bool compares_exactly(clang::Expr const *side, clang::Expr const *constant);
  // The type as a cast or a macro argument spells it in any scope: value_type is a name in its class only.
  std::string spelled(clang::QualType type) const;

  using Arguments = llvm::ArrayRef<clang::Expr const *>;
  // `call`: location of the call.
  void arguments(clang::SourceLocation call, clang::FunctionDecl const *function, Arguments arguments, bool overloaded);
  void literal_argument(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument,
                        bool overloaded, unsigned count, Use use = Use::literal);
  void outside_argument(clang::SourceLocation call, clang::FunctionDecl const *function, unsigned index,
                        clang::Expr const *argument);
  void constant_arguments(clang::FunctionDecl const *function, Arguments arguments, bool outside);
  bool takes_only(clang::FunctionDecl const *function) const;
  bool may_be_truth(clang::Expr const *argument) const;
  void instantiated_arguments(clang::FunctionDecl const *function, Arguments arguments);
  void extreme_argument(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument);
  void truth_argument(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument,
                      bool overloaded);
  void bytes_of_arguments(clang::CallExpr const *call, clang::FunctionDecl const *function);

  void reinterpretation(clang::ExplicitCastExpr const *cast);
  void view(clang::ExplicitCastExpr const *cast, bool of_integers);
  bool shares_bytes(clang::FieldDecl const *field) const;
  bool shares_number(clang::FieldDecl const *field) const;
  clang::Expr const *whole_member(clang::MemberExpr const *member) const;
  void bits_of_union(clang::MemberExpr const *member, clang::FieldDecl const *field);
  void store_to_union(clang::Expr const *left);
  void number_of_union(clang::Expr const *value);
  bool view_of_union(clang::Expr const *part);
  // `reads`: the stored value depends on the old one.
  void store_to_view(clang::Expr const *left, bool reads);
  bool use_of_view(clang::Expr const *value, clang::DeclRefExpr const *name);
  void uses_of_views();
  void looked_into(clang::Expr const *address);
  bool moved_bytes(clang::CallExpr const *call, clang::FunctionDecl const *function);
  bool is_lasting_array(clang::Expr const *expression) const;
  void given_bytes(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument);
  // `named`: the expression that supplies name and place, if it is another one. `words`: further arguments of the
  // macro, before them.
  void note(clang::Expr const *expression, Use use, clang::Expr const *named = nullptr, std::string const &words = "");
  // On one line, and cut off where it is long.
  std::string short_text(Span const &span, clang::SourceLocation at) const;
  bool may_outlive(clang::Expr const *expression) const;
  void scalar(clang::Expr const *expression, Use use);
  bool is_fixed(clang::Expr const *expression) const;
  void decides(clang::Expr const *expression);
  void dispatch(clang::CXXMemberCallExpr const *call);
  void decides_by_pointer(clang::Expr const *object);
  // A pointer gets a new value.
  void pointer(clang::Expr const *expression);
  bool holds_state(clang::QualType type) const { return reals_.carries_real(type) || scalars_.holds(type); }
  void object(clang::Expr const *expression, Use use);
  bool is_value(clang::QualType type) const;
  void changed_value(clang::Expr const *expression);
  void leads(clang::Expr const *expression);
  void target(clang::Expr const *pointer);
  void looked_into_whole(clang::FunctionDecl const *function, clang::Expr const *argument);
  void targets(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void library_arguments(clang::FunctionDecl const *function, Arguments arguments);
  void library_object(clang::CallExpr const *call, clang::FunctionDecl const *function, clang::Expr const *object);
  bool begins_range(Arguments arguments, std::size_t first) const;
  void range(Arguments arguments, std::size_t first, Use begin, Use end);
  void operator_call(clang::CXXOperatorCallExpr const *call, clang::FunctionDecl const *function);

  // Width in which gcc's C computes an integer; 0 bits for other types.
  struct Width {
    unsigned bits = 0;
    bool is_signed = true;
    bool is_narrow() const { return bits > 32 && bits != 64 && bits != 128; }
  };
  static Width common(Width one, Width other);
  Width width_of(clang::Expr const *expression);
  Width computed_width(clang::Expr const *expression);
  void as_width(clang::SourceLocation operation, clang::Expr const *operand, Width width);

  void wrap(clang::Expr const *expression, Use use, std::string detail = {});
  // Wraps the expression for `user` alone (SourceMap::range_for).
  std::optional<Span> wrap_for(clang::SourceLocation user, clang::Expr const *expression, Use use,
                               std::string detail = {});
  void type_asked(clang::SourceLocation user, clang::Expr const *expression, std::string const &place);
  // Spells an implicit conversion out.
  void convert(clang::Expr const *expression, Use use, std::string type);
  void converted_number(clang::ImplicitCastExpr const *cast, bool decides);
  void report(DiagnosticId id, clang::SourceLocation location, std::string message,
              std::optional<Severity> unusual = {});
  // Whether an initializer or argument is a literal that stays double in the symbolic program.
  bool is_plain_double(clang::Expr const *expression) const;

  clang::ASTContext &context_;
  SourceMap const &map_;
  Reals const &reals_;
  ScalarState const &scalars_;
  WrittenFirst written_first_;
  Surroundings const &surroundings_;
  Storage const storage_;
  NamedVariableAnalysis named_variables_;
  Facts &facts_;
  struct Waiting {
    std::optional<Note> instance;
    std::function<void()> handler;
  };
  std::vector<Waiting> waiting_;
  clang::FunctionDecl const *const *function_ = nullptr;
  // State shared between handlers.
  llvm::SmallPtrSet<clang::Expr const *, 32> judged_;        // names whose use is noted already
  llvm::SmallPtrSet<clang::Expr const *, 8> printed_;        // copies made for printing
  llvm::SmallPtrSet<clang::Expr const *, 8> iterators_;      // calls that return one without reading through it
  llvm::SmallPtrSet<clang::Expr const *, 4> counting_casts_; // to bytes, only for address arithmetic or free
  llvm::SmallPtrSet<clang::VarDecl const *, 4> views_;       // local pointers to integers that point to numbers
  std::vector<std::pair<clang::Expr const *, clang::DeclRefExpr const *>>
      through_pointers_; // reads that may go through those
  std::vector<std::pair<clang::Expr const *, clang::DeclRefExpr const *>> stores_through_; // stores that may
  llvm::SmallPtrSet<clang::VarDecl const *, 4> views_of_one_;   // those that point to a single number
  llvm::SmallPtrSet<clang::Expr const *, 4> compared_exactly_;  // exact conversions to long double
  llvm::SmallPtrSet<clang::Expr const *, 4> compared_pointers_; // conversions that C++ makes as well
  llvm::SmallPtrSet<clang::Expr const *, 8> promoted_;          // argument conversions that are written out
  llvm::DenseMap<clang::Expr const *, Width> widths_;
  llvm::SmallPtrSet<clang::Expr const *, 32> callees_;   // names of called functions
  std::optional<Note> instance_;                         // the instantiation being visited
  llvm::SmallPtrSet<clang::Expr const *, 32> discarded_; // calls whose value is unused
};

} // namespace symreal::rewrite
