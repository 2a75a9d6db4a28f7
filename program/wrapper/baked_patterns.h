// Helpers of the checks of baked-in values, and of the program that prints the values: as text, C99 or C++11.
#pragma once

namespace symreal::program::patterns {

// The value of an element as 64 bits.
inline constexpr char const *hashes = R"(static __inline__ unsigned long long symreal_bits(double symreal_number) {
  unsigned long long symreal_result;
  __builtin_memcpy(&symreal_result, &symreal_number, sizeof symreal_result);
  return symreal_result;
}
/* The bits of both doubles that it is the sum of. */
static __inline__ unsigned long long symreal_wide(long double symreal_number) {
  double const symreal_high = (double)symreal_number;
  return symreal_bits(symreal_high) * 1099511628211ull + symreal_bits((double)(symreal_number - symreal_high));
}
static __inline__ unsigned long long symreal_text(char const *symreal_string) {
  unsigned long long symreal_hash = 14695981039346656037ull;
  if (!symreal_string) return 0;
  for (; *symreal_string; ++symreal_string) symreal_hash = (symreal_hash ^ (unsigned char)*symreal_string) * 1099511628211ull;
  return symreal_hash;
}
)";

// Relative position of two ranges: the distance of their begins if they overlap.
inline constexpr char const *apart =
    R"(static __inline__ unsigned long long symreal_apart(void const volatile *symreal_a, void const volatile *symreal_a_end, void const volatile *symreal_b, void const volatile *symreal_b_end) {
  __UINTPTR_TYPE__ const symreal_first = (__UINTPTR_TYPE__)symreal_a, symreal_second = (__UINTPTR_TYPE__)symreal_b;
  int const symreal_meet = symreal_first < (__UINTPTR_TYPE__)symreal_b_end && symreal_second < (__UINTPTR_TYPE__)symreal_a_end;
  return symreal_meet ? (unsigned long long)(symreal_second - symreal_first) : 1ull << 63;
}
)";

// In C++, address range of an object's numbers: its own, or those that it refers to.
inline constexpr char const *ranges = R"(namespace {
template <int symreal_n> struct symreal_order : symreal_order<symreal_n - 1> {};
template <> struct symreal_order<0> {};
template <class symreal_T> void const volatile *symreal_address(symreal_T const &symreal_object) {
  return &reinterpret_cast<char const volatile &>(symreal_object);
}
template <class symreal_T>
auto symreal_begin(symreal_T const &symreal_object, symreal_order<2>)
    -> decltype(symreal_object.rowStride(), symreal_object.colStride(), static_cast<void const volatile *>(symreal_object.data())) {
  return symreal_object.data();
}
template <class symreal_T>
auto symreal_begin(symreal_T const &symreal_object, symreal_order<1>)
    -> decltype(symreal_object.size(), static_cast<void const volatile *>(static_cast<double const volatile *>(symreal_object.data()))) {
  return symreal_object.data();
}
template <class symreal_T> void const volatile *symreal_begin(symreal_T const &symreal_object, symreal_order<0>) {
  return symreal_address(symreal_object);
}
template <class symreal_T>
auto symreal_end(symreal_T const &symreal_object, symreal_order<2>)
    -> decltype(symreal_object.rowStride(), symreal_object.colStride(), static_cast<void const volatile *>(symreal_object.data())) {
  return symreal_object.size() == 0 ? symreal_object.data()
                                    : symreal_object.data() + (symreal_object.rows() - 1) * symreal_object.rowStride() +
                                          (symreal_object.cols() - 1) * symreal_object.colStride() + 1;
}
template <class symreal_T>
auto symreal_end(symreal_T const &symreal_object, symreal_order<1>)
    -> decltype(symreal_object.size(), static_cast<void const volatile *>(static_cast<double const volatile *>(symreal_object.data()))) {
  return symreal_object.data() + symreal_object.size();
}
template <class symreal_T> void const volatile *symreal_end(symreal_T const &symreal_object, symreal_order<0>) {
  return &reinterpret_cast<char const volatile &>(symreal_object) + sizeof symreal_object;
}
template <class symreal_T> void const volatile *symreal_low(symreal_T const &symreal_object) {
  return symreal_begin(symreal_object, symreal_order<2>());
}
template <class symreal_T> void const volatile *symreal_high(symreal_T const &symreal_object) {
  return symreal_end(symreal_object, symreal_order<2>());
}
}
)";

// Visits extents and numbers of any container, as 64 bits each.
inline constexpr char const *visits = R"(namespace {
template <int symreal_n> struct symreal_rank : symreal_rank<symreal_n - 1> {};
template <> struct symreal_rank<0> {};
inline unsigned long long symreal_scalar(double symreal_number) { return symreal_bits(symreal_number); }
inline unsigned long long symreal_scalar(float symreal_number) { return symreal_bits(symreal_number); }
inline unsigned long long symreal_scalar(long double symreal_number) { return symreal_wide(symreal_number); }
template <class symreal_T> unsigned long long symreal_scalar(symreal_T const &symreal_object) {
  return static_cast<unsigned long long>(symreal_object);
}
template <class symreal_T, class symreal_Visit>
void symreal_all(symreal_T const &symreal_object, symreal_Visit &symreal_visit);
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<4>)
    -> decltype(static_cast<void>(static_cast<unsigned long long>(symreal_object))) {
  symreal_visit(symreal_scalar(symreal_object));
}
template <class symreal_T, __SIZE_TYPE__ symreal_n, class symreal_Visit>
void symreal_enter(symreal_T const (&symreal_array)[symreal_n], symreal_Visit &symreal_visit, symreal_rank<3>) {
  for (__SIZE_TYPE__ symreal_i = 0; symreal_i < symreal_n; ++symreal_i) symreal_all(symreal_array[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<2>)
    -> decltype(symreal_object.rows(), symreal_object.cols(), static_cast<void>(symreal_object(0, 0))) {
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.rows()));
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.cols()));
  for (decltype(symreal_object.rows() + 0) symreal_i = 0; symreal_i < symreal_object.rows(); ++symreal_i)
    for (decltype(symreal_object.cols() + 0) symreal_j = 0; symreal_j < symreal_object.cols(); ++symreal_j)
      symreal_all(symreal_object(symreal_i, symreal_j), symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<1>)
    -> decltype(symreal_object.size(), static_cast<void>(symreal_object[0])) {
  symreal_visit.symreal_extent(static_cast<unsigned long long>(symreal_object.size()));
  for (decltype(symreal_object.size() + 0) symreal_i = 0; symreal_i < symreal_object.size(); ++symreal_i)
    symreal_all(symreal_object[symreal_i], symreal_visit);
}
template <class symreal_T, class symreal_Visit>
auto symreal_enter(symreal_T const &symreal_object, symreal_Visit &symreal_visit, symreal_rank<0>)
    -> decltype(symreal_object.real(), static_cast<void>(symreal_object.imag())) {
  symreal_all(symreal_object.real(), symreal_visit);
  symreal_all(symreal_object.imag(), symreal_visit);
}
template <class symreal_T, class symreal_Visit>
void symreal_all(symreal_T const &symreal_object, symreal_Visit &symreal_visit) {
  symreal_enter(symreal_object, symreal_visit, symreal_rank<4>());
}
struct symreal_comparer {
  unsigned long long const *symreal_known;
  unsigned long long symreal_met;
  bool symreal_differs;
  void operator()(unsigned long long symreal_value) {
    symreal_differs = symreal_differs || symreal_met >= symreal_known[0] || symreal_known[symreal_met + 1] != symreal_value;
    ++symreal_met;
  }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
template <class symreal_Visit> struct symreal_extents_alone {
  symreal_Visit &symreal_visit;
  void operator()(unsigned long long) {}
  void symreal_extent(unsigned long long symreal_value) { symreal_visit(symreal_value); }
};
template <class symreal_T, class symreal_Visit>
void symreal_each_of(symreal_T const &symreal_object, bool symreal_is_whole, symreal_Visit &symreal_visit) {
  symreal_extents_alone<symreal_Visit> symreal_alone = {symreal_visit};
  if (symreal_is_whole)
    symreal_all(symreal_object, symreal_visit);
  else
    symreal_all(symreal_object, symreal_alone);
}
template <class symreal_T>
bool symreal_is_other(symreal_T const &symreal_object, bool symreal_is_whole, unsigned long long const *symreal_known, unsigned long &symreal_at) {
  symreal_comparer symreal_visit = {symreal_known + symreal_at, 0, false};
  symreal_each_of(symreal_object, symreal_is_whole, symreal_visit);
  bool const symreal_result = symreal_visit.symreal_differs || symreal_visit.symreal_met != symreal_known[symreal_at];
  symreal_at += 1 + symreal_known[symreal_at];
  return symreal_result;
}
}
)";

// Helpers of the program that prints the values.
inline constexpr char const *tellers_in_c = R"(
char const *symreal_requested(char const *);
int symreal_create(char const *, unsigned) __asm__("creat");
int symreal_print(int, char const *, ...) __asm__("dprintf");
void symreal_quit(int) __asm__("_exit");
)";
inline constexpr char const *tellers_in_cxx = R"(namespace {
struct symreal_counter_of_all {
  unsigned long long symreal_count;
  void operator()(unsigned long long) { ++symreal_count; }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
struct symreal_teller {
  int symreal_file;
  void operator()(unsigned long long symreal_value) { symreal_print(symreal_file, "%llu\n", symreal_value); }
  void symreal_extent(unsigned long long symreal_value) { (*this)(symreal_value); }
};
template <class symreal_T> void symreal_tell(int symreal_file, symreal_T const &symreal_object, bool symreal_is_whole) {
  symreal_counter_of_all symreal_counter = {0};
  symreal_each_of(symreal_object, symreal_is_whole, symreal_counter);
  symreal_teller symreal_visit = {symreal_file};
  symreal_visit(symreal_counter.symreal_count);
  symreal_each_of(symreal_object, symreal_is_whole, symreal_visit);
}
}
)";

} // namespace symreal::program::patterns
