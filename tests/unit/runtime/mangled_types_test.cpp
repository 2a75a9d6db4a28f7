#include "runtime/trace/text/type_names.h"

#include <symreal/real_number.h>
#include <symreal/symbolic_int.h>

#include <array>
#include <complex>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <typeinfo>
#include <variant>
#include <vector>

namespace symreal::trace {
namespace {

namespace shapes {
template <class T> struct Point {
  struct Part {};
  template <class U> struct Other {};
  enum Kind { first };
  template <class U> std::string local(U) const {
    struct Local {};
    return typeid(std::vector<Local>).name();
  }
};
template <class T, int count> struct Row {};
template <template <class...> class Container, class T> struct Held {};
template <class... T> struct Pack {};
template <auto value> struct Value {};
template <class T> int function(T) { return 0; }
} // namespace shapes

template <class T> std::string in_static(T, shapes::Point<T> const &, shapes::Point<T> *) {
  struct Local {};
  return typeid(std::map<Local, T>).name();
}

template <class T> std::vector<std::string> names() {
  using shapes::Pack, shapes::Point, shapes::Row, shapes::Value;
  return {typeid(T).name(),
          typeid(T **).name(),
          typeid(T const *const *).name(),
          typeid(T[3]).name(),
          typeid(T(*)[4][5]).name(),
          typeid(std::vector<std::vector<T>>).name(),
          typeid(std::map<std::string, std::vector<T>>).name(),
          typeid(std::pair<std::vector<T> const, std::vector<T> *>).name(),
          typeid(std::complex<T>).name(),
          typeid(std::function<T(T, T const &, T *)>).name(),
          typeid(std::unique_ptr<T[]>).name(),
          typeid(std::array<T, 3>).name(),
          typeid(std::tuple<T, int, T, std::tuple<T, T *>, T *>).name(),
          typeid(typename std::vector<T>::iterator).name(),
          typeid(Point<Point<T>>).name(),
          typeid(typename Point<T>::Part).name(),
          typeid(typename Point<Point<T>>::template Other<typename Point<T>::Part>).name(),
          typeid(Row<T, -3>).name(),
          typeid(shapes::Held<std::vector, T>).name(),
          typeid(Pack<>).name(),
          typeid(Pack<T, Pack<>, T *, Pack<T> *, Pack<T>>).name(),
          typeid(Value<Point<T>::first>).name(),
          typeid(Value<&shapes::function<T>>).name(),
          typeid(T Pack<>::*).name(),
          typeid(T(Point<T>::*)(T, Point<T> *) const &).name(),
          typeid(T(T) noexcept).name(),
          typeid(void (*)(T &, T &&, ...)).name(),
          Point<T>().local(Pack<T>()),
          in_static<T>(T(), {}, nullptr)};
}

TEST(MangledTypes, NamesOfTypesAreThoseOfTheOriginal) {
  std::vector<std::string> const ours = names<RealNumber>(), original = names<double>();
  for (std::size_t k = 0; k < ours.size(); ++k) {
    EXPECT_EQ(original_type_name(ours[k]), original[k]) << ours[k];
    EXPECT_EQ(original_type_name(original[k]), original[k]);
  }
}

TEST(MangledTypes, TruthsAndIntegersStandForThoseOfTheLanguage) {
  EXPECT_EQ(original_type_name("N7symreal5types12SymbolicBoolE"), "b");
  EXPECT_EQ(original_type_name("St4pairIN7symreal5types11SymbolicIntIlEEKS3_E"),
            typeid(std::pair<long, long const>).name());
}

TEST(MangledTypes, WhatIsNotReadHasNoName) {
  auto const lambda = [](RealNumber) {};
  EXPECT_EQ(original_type_name(typeid(lambda).name()), std::nullopt);
  for (char const *name :
       {"", "S_", "3ab", "N", "NE", "St", "P", "1aI", "1aId", "A3", "Fv", "Z1f", "DTcl1fEE", "ddd", "T0"})
    EXPECT_EQ(original_type_name(name), std::nullopt) << name;
}

} // namespace
} // namespace symreal::trace
