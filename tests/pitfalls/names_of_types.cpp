// The name of a type is that of the original: from typeid, in the signature of a template's instantiation, from a source
// location. So are its hash and its place in an order.
// RUN: %same %s -- -std=c++20
// RUN: %rewrite %s -- -std=c++20 > %t.rewritten.cpp && FileCheck %s --check-prefix=TEXT < %t.rewritten.cpp
// RUN: %rewrite %t.rewritten.cpp -- -std=c++20 | diff %t.rewritten.cpp -
// RUN: %symreal generate %s -o %t.c -- -std=c++20 && %symreal verify %s %t.c --samples=50 -- -std=c++20
// RUN: grep -v "pragma symreal" %s > %t.plain.cpp
// RUN: %cxx -std=c++20 %t.plain.cpp -o %t.original && %symreal-c++ -std=c++20 %t.plain.cpp -o %t.symbolic
// RUN: %t.original > %t.expected && %t.symbolic | diff %t.expected -
#include <any>
#include <cstdio>
#include <cxxabi.h>
#include <functional>
#include <map>
#include <memory>
#include <source_location>
#include <string>
#include <string_view>
#include <typeindex>
#include <typeinfo>
#include <vector>

// TEXT: return REAL_EITHER((__PRETTY_FUNCTION__), SYMREAL_SIGNATURE);
template <class T> constexpr std::string_view name() { return __PRETTY_FUNCTION__; }
template <class T> struct Named {
  static constexpr std::string_view of(T) { return __PRETTY_FUNCTION__; }
  virtual ~Named() = default;
};
static double signature(double, double const *) { return sizeof __PRETTY_FUNCTION__; }
template <class T> std::string_view here(T, std::source_location place = std::source_location::current()) {
  return place.function_name();
}
template <class T> std::string demangled() {
  int status = 0;
  std::unique_ptr<char, void (*)(void *)> const text(abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, &status),
                                                     std::free);
  return text.get();
}
template <class T> double sign(T x) {
  double result = name<T>().find("double") != std::string_view::npos ? 1 : -1;
  if constexpr (name<T>().ends_with("double]")) result += 2;
  result += Named<T>::of(x).size();
  if (std::string_view(typeid(T).name()) == "d") result += 100;
  if (std::string_view(typeid(x > 1).name()) == "b") result += 200;
  if (typeid(T).hash_code() == typeid(double).hash_code()) result += 400;
  if (typeid(T).before(typeid(int))) result += 800;
  if (std::type_index(typeid(T *)).name() == std::string_view("Pd")) result += 1600;
  std::any const kept = x;
  if (kept.type() == typeid(T)) result += 3200;
  if (kept.type().name() == std::string_view("d")) result += 6400;
  if (here(x).find("double") != std::string_view::npos) result += 12800;
  return result;
}
double of_containers(double x) {
  struct Local {
    double y;
  };
  std::any const kept = std::vector<double>{x};
  std::unique_ptr<Named<int>> const some = std::make_unique<Named<int>>();
  // TEXT: REAL result = std::string_view(REAL_NAMED("{{.*}}names_of_types.cpp:[[@LINE+1]]:36", typeid(std::vector<REAL>)).name()).size();
  double result = std::string_view(typeid(std::vector<double>).name()).size();
  result += typeid(std::map<std::string, Named<double>>).name()[40] + typeid(Local).name()[14];
  result += kept.type().name()[3] + demangled<std::function<double(double)>>().size() + typeid(*some).name()[0];
  std::map<std::type_index, double> ranks;
  ranks[typeid(std::vector<double>)] = 1e16;
  ranks[typeid(std::vector<int>)] = -1e16;
  ranks[typeid(double)] = 1;
  ranks[typeid(Named<double>)] = 3;
  ranks[typeid(std::string)] = 5;
  for (auto const &[type, rank] : ranks) result = result * 0.5 + rank * x; // in their order
  return result;
}

#pragma symreal function input(x) output(return)
double kernel(double x) { return x * sign(x) + signature(x, &x) + of_containers(x); }

int main() {
  std::printf("%.17g\n", kernel(0.5));
  std::printf("%s %s\n", name<double>().data(), Named<double *>::of(nullptr).data());
  std::printf("%s %s\n", typeid(Named<Named<double>>).name(), demangled<std::map<double, std::vector<double>>>().c_str());
}
