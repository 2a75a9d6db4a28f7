#include "rewrite/model/overlaps.h"

#include "rewrite/model/storage.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::rewrite {
namespace {

using namespace clang;

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
