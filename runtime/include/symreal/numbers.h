// Traversal of an object's numbers, shared by annotations and the detection of hidden state.
#pragma once

#include <symreal/real_number.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace symreal {

namespace detail {

template <class T, class = void> struct is_matrix : std::false_type {};
template <class T>
struct is_matrix<T, std::void_t<decltype(std::declval<T &>().rows()), decltype(std::declval<T &>().cols()),
                                decltype(std::declval<T &>()(0, 0))>> : std::true_type {};
template <class T, class = void> struct is_sequence : std::false_type {};
template <class T>
struct is_sequence<T, std::void_t<decltype(std::declval<T &>().size()), decltype(std::declval<T &>()[0])>>
    : std::true_type {};
template <class T, class = void> struct is_complex : std::false_type {};
template <class T> struct is_complex<
    T, std::enable_if_t<std::is_same_v<typename T::value_type, std::decay_t<decltype(std::declval<T &>().imag())>>>>
    : std::true_type {};

// One of Eigen's types whose elements lie in memory at regular distances. An expression such as a transposed product
// has the members, too, but they do not compile: Eigen tells the two apart by a flag.
template <class T> constexpr bool has_strides() {
  constexpr unsigned direct_access = 0x40; // Eigen::DirectAccessBit
  if constexpr (requires { T::Flags, T::IsRowMajor; }) return (static_cast<unsigned>(T::Flags) & direct_access) != 0;
  return false;
}

template <class T> constexpr bool integer_type() {
  if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) return sizeof(T) <= 8;
  return false;
}
template <class T> inline constexpr bool is_integer = integer_type<T>();
// float and long double. A REAL is a class to which the traits answer as to double; a double itself occurs only in code
// that is not rewritten.
template <class T> inline constexpr bool is_narrow_or_wide =
    std::is_floating_point_v<T> && !is_class<T> && !std::is_same_v<std::remove_cv_t<T>, double>;
template <class T> inline constexpr bool is_function_pointer =
    (std::is_pointer_v<T> && std::is_function_v<std::remove_pointer_t<T>>) || std::is_member_pointer_v<T>;
template <class T> inline constexpr bool is_scalar = is_integer<T> || is_narrow_or_wide<T> || is_function_pointer<T>;
// True for a library class with a value besides its numbers and elements: text, std::variant, std::any, std::function,
// std::atomic, std::bitset, std::vector<bool>, std::weak_ptr, std::chrono::duration.
template <class T> constexpr bool has_value_of_its_own() {
  return requires(T const &object) { object.c_str(); } ||
         requires(T const &object) { object.valueless_by_exception(); } ||
         requires(T const &object) { object.target_type(); } ||
         requires(T const &object) { object.has_value(), object.type(); } ||
         requires(T const &object) { object.load(), object.is_lock_free(); } ||
         requires(T const &object) { object.expired(); } || requires(T const &object) { object.to_ullong(); } ||
         requires(T const &object) {
           typename T::period;
           object.count();
         } || requires(T &object) { object.flip(); };
}
template <class T> inline constexpr bool is_smart_pointer =
    requires { typename T::deleter_type; } || requires(T const &object) { object.use_count(), *object; };
// Text is data of another kind.
template <class T> inline constexpr bool is_text =
    std::is_same_v<T, char> || std::is_same_v<T, wchar_t> || std::is_same_v<T, char16_t> || std::is_same_v<T, char32_t>;

} // namespace detail

// A value in memory that is not a REAL: an integer, a truth value, an enumerator, a float or long double, a pointer to
// a function; or an object of a library that has a value of its own, such as whether an optional is there. Text and
// pointers to objects are judged only where they decide something.
struct ScalarObject {
  enum class Kind : unsigned char { natural, integer, floating, pointer, object, text, target };

  void const *address;
  unsigned char size; // in bytes, at most 8 of an integer; 1 of an object, for all of it
  Kind kind;

  template <class T> static ScalarObject of(T const &object) {
    auto const *address = const_cast<std::remove_cv_t<T> const *>(&object);
    if constexpr (detail::is_narrow_or_wide<T>) {
      constexpr std::size_t extended = 10; // bytes of the sixteen of a long double
      return {address,
              sizeof object == 16 && std::is_same_v<std::remove_cv_t<T>, long double> ? extended : sizeof object,
              Kind::floating};
    } else if constexpr (std::is_enum_v<T>)
      return {address, sizeof object, std::is_signed_v<std::underlying_type_t<T>> ? Kind::integer : Kind::natural};
    else if constexpr (detail::is_integer<T>)
      return {address, sizeof object, std::is_signed_v<T> ? Kind::integer : Kind::natural};
    else
      return {address, sizeof object, Kind::pointer};
  }
};

// Visits the numbers and scalars in an object and in the storage that it owns. Pointers that own nothing are not
// followed.
//
// A class of the rewritten sources tells its members itself: the rewriter gives it a function `symreal_members`.
class Numbers {
public:
  // `found` is called with the address of each number and, if it takes them, with each scalar. It must outlive this
  // object.
  template <class Found> explicit Numbers(Found &found)
      : context_(&found),
        found_([](void *context, RealNumber const *number) { (*static_cast<Found *>(context))(number); }) {
    if constexpr (std::is_invocable_v<Found &, ScalarObject>)
      found_scalar_ = [](void *context, ScalarObject scalar) { (*static_cast<Found *>(context))(scalar); };
  }

  template <class T> static constexpr bool may_hold = detail::is_class<T> || std::is_union_v<T> || std::is_array_v<T>;

  template <class... T> void visit(T const &...objects) { (one(objects), ...); }
  template <class... T> void symreal_visit(T const &...objects) { visit(objects...); }

private:
  template <class T> static constexpr bool holds_elements() {
    return !std::is_same_v<T, double> && !detail::is_text<T>;
  }

  template <class T> void one(T const &object) {
    if constexpr (std::is_same_v<T, RealNumber>) {
      found_(context_, &object);
    } else if constexpr (detail::is_symbolic_int<T>) {
      words(object);
    } else if constexpr (detail::is_scalar<T>) {
      if (found_scalar_) found_scalar_(context_, ScalarObject::of(object));
    } else if constexpr (std::is_pointer_v<T>) {
      target(object);
    } else if constexpr (!may_hold<T> || !requires { sizeof(T); }) { // sizeof: what a pointer owns may be unknown here
    } else if constexpr (std::is_array_v<T>) {
      if constexpr (!detail::is_text<std::remove_cv_t<std::remove_extent_t<T>>>)
        for (auto const &part : object) one(part);
    } else if constexpr (requires(Numbers &numbers) { object.symreal_members(numbers); }) {
      object.symreal_members(*this);
    } else if constexpr (detail::has_value_of_its_own<T>()) {
      whole(object);
    } else if constexpr (detail::is_complex<T>::value) {
      one(reinterpret_cast<typename T::value_type const(&)[2]>(object)); // as the standard lays it out
    } else if constexpr (detail::has_strides<T>()) {
      strided(object); // Eigen's matrices, and maps and blocks of them, some of which give copies of their elements
    } else if constexpr (detail::is_matrix<T const>::value) {
      if constexpr (std::is_lvalue_reference_v<decltype(object(0, 0))>)
        for (decltype(object.rows()) i = 0; i < object.rows(); ++i)
          for (decltype(object.cols()) j = 0; j < object.cols(); ++j) one(object(i, j));
    } else if constexpr (detail::is_sequence<T const>::value) {
      if constexpr (std::is_lvalue_reference_v<decltype(object[0])>)
        if constexpr (holds_elements<std::remove_cvref_t<decltype(object[0])>>())
          for (decltype(object.size()) i = 0; i < object.size(); ++i) one(object[i]);
    } else if constexpr (requires { object.begin() != object.end(); }) {
      if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(*object.begin())>, T>)
        for (auto const &part : object) one(part);
    } else if constexpr (requires { object.first, object.second; }) {
      visit(object.first, object.second);
    } else if constexpr (
        requires {
          typename T::deleter_type;
          *object;
        } || requires { object.has_value(), *object; }) {
      if constexpr (requires { object.has_value(); })
        whole(object);
      else
        target(object);
      if (object) one(*object);
    } else if constexpr (requires { object.coeffs(); }) { // Eigen's Quaternion
      one(object.coeffs());
    } else if constexpr (requires { object.axis(), object.angle(); }) { // Eigen's AngleAxis
      visit(object.axis(), const_cast<T &>(object).angle());
    } else if constexpr (requires { object.vector(); }) { // Eigen's Translation
      one(object.vector());
    } else if constexpr (requires { std::tuple_size<T>::value; }) {
      parts(object, std::make_index_sequence<std::tuple_size_v<T>>());
    } else if constexpr (std::is_aggregate_v<T> && std::is_trivially_copyable_v<T> && alignof(T) == 8) {
      words(object); // a plain structure without a name of its own, or of code that is not rewritten
    }
  }

  // The elements of a std::tuple; references lead to objects of others.
  template <class T, std::size_t... k> void parts(T const &object, std::index_sequence<k...>) {
    using std::get;
    (part<std::tuple_element_t<k, T>>(get<k>(object)), ...);
  }
  template <class Declared, class T> void part(T const &object) {
    if constexpr (!std::is_reference_v<Declared>) one(object);
  }

  template <class T> void strided(T const &object) {
    auto const across = T::IsRowMajor ? object.outerStride() : object.innerStride();
    auto const along = T::IsRowMajor ? object.innerStride() : object.outerStride();
    for (decltype(object.rows()) i = 0; i < object.rows(); ++i)
      for (decltype(object.cols()) j = 0; j < object.cols(); ++j) one(object.data()[i * across + j * along]);
  }

  template <class T> void words(T const &object) {
    auto const *numbers = reinterpret_cast<RealNumber const *>(&object);
    for (std::size_t k = 0; k < sizeof object / sizeof(RealNumber); ++k) found_(context_, numbers + k);
  }

  template <class T> void whole(T const &object) {
    constexpr auto kind = requires { object.c_str(); } ? ScalarObject::Kind::text : ScalarObject::Kind::object;
    if (found_scalar_) found_scalar_(context_, {&object, 1, kind});
  }

  template <class T> void target(T const &pointer) {
    if (found_scalar_) found_scalar_(context_, {&pointer, sizeof(void *), ScalarObject::Kind::target});
  }

  void *context_;
  void (*found_)(void *, RealNumber const *);
  void (*found_scalar_)(void *, ScalarObject) = nullptr;
};

} // namespace symreal
