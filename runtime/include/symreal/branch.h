// Runtime side of rewritten decisions (REAL_IF, REAL_COND, REAL_LOOP, ...), which state both arms and their assigned
// variables. If the condition is symbolic and the policy is `select`, both arms are executed and each assigned variable
// becomes a select; otherwise they are the original's statements, and the decision is an ordinary one.
#pragma once

#include <symreal/annotate.h>
#include <symreal/decisions.h>
#include <symreal/list.h>
#include <symreal/symbolic_int.h>
#include <symreal/truth.h>

#include <cstring>

namespace symreal {

namespace detail {

// The plain type of a truth value, an enumerator or an integer, symbolic or not; void for a REAL or a double.
template <class T, class = int> struct ArmOf {
  using Type = void;
};
template <class T> struct ArmOf<T, IfInteger<T>> {
  using Type = Promoted<T>;
};
template <class T> struct ArmOf<SymbolicInt<T>> {
  using Type = T;
};
template <> struct ArmOf<SymbolicBool> {
  using Type = bool;
};
// Two integers become one of the type that is common to both before that becomes a number: c ? -1 : 2u.
template <class A, class B, class = void> struct ChosenOf {
  using Type = RealNumber;
};
template <class A, class B> struct ChosenOf<A, B, std::void_t<Common<A, B>>> {
  using Type = SymbolicInt<Common<A, B>>;
};
template <class YesArm, class NoArm> using Chosen =
    typename ChosenOf<typename ArmOf<std::remove_cvref_t<YesArm>>::Type,
                      typename ArmOf<std::remove_cvref_t<NoArm>>::Type>::Type;

} // namespace detail

// c ? yes() : no()
template <class C, class Yes, class No>
[[gnu::always_inline]] inline auto symreal_choose(C const &condition, Yes const &yes, No const &no) {
  using YesArm = decltype(yes());
  using NoArm = decltype(no());
  using Result = detail::Chosen<YesArm, NoArm>;
  if constexpr (!is_symbolic_truth<C> && detail::is_symbolic_int<YesArm> != detail::is_symbolic_int<NoArm>) {
    if (condition) return Result(yes()); // neither converts to the other rather than the other way
    return Result(no());
  } else if constexpr (!is_symbolic_truth<C>) {
    return condition ? yes() : no();
  } else {
    static_assert(std::is_constructible_v<Result, YesArm> && std::is_constructible_v<Result, NoArm>,
                  "symreal: only numbers can be chosen symbolically");
    SymbolicBool const chosen(symreal_truth(condition));
    if (!chosen.is_symbolic() || !detail::selects()) {
      if (chosen) return Result(yes());
      return Result(no());
    }
    Result y, n;
    {
      PathScope path(chosen);
      y = Result(yes());
    }
    {
      PathScope path(!chosen);
      n = Result(no());
    }
    return select(chosen, y, n);
  }
}

// The numbers that the arms assign, and their former values.
class Targets {
public:
  // targets(x)(y)...
  template <class T> Targets &operator()(T &object) {
    if constexpr (std::is_same_v<T, RealNumber>)
      numbers_.push_back(&object);
    else if constexpr (std::is_array_v<T>)
      for (auto &element : object) (*this)(element);
    else if constexpr (detail::is_symbolic_int<T>)
      integer(object);
    else if constexpr (detail::is_matrix<T>::value) {
      for (decltype(object.rows()) i = 0; i < object.rows(); ++i)
        for (decltype(object.cols()) j = 0; j < object.cols(); ++j) (*this)(object(i, j));
    } else if constexpr (detail::is_class<T>) { // it holds nothing but numbers: the rewriter has looked
      static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(RealNumber) == 0);
      for (std::size_t k = 0; k < sizeof(T) / sizeof(RealNumber); ++k)
        numbers_.push_back(reinterpret_cast<RealNumber *>(&object) + k);
    } else
      has_others_ = true; // a template's instantiation on another type
    return *this;
  }

  bool has_others() const noexcept { return has_others_; }
  List<RealNumber> values() const;
  // Indices of the targets that outlive the kernel and that it has not met yet: their values are not the kernel's.
  List<std::size_t> foreign() const;
  // Flags the targets that were written since; they count as not met again.
  List<bool> take_written(List<std::size_t> const &foreign) const;
  // One arm alone has written these, or they were written and may keep their former value: it is part of the result.
  void keep(List<std::size_t> const &foreign, List<bool> const &written_before, List<RealNumber> const &values) const;
  void restore(List<RealNumber> const &values) const;
  // Assigns select(condition, yes, no) to each target.
  [[gnu::always_inline]] void merge(SymbolicBool condition, List<RealNumber> const &yes,
                                    List<RealNumber> const &no) const {
    std::size_t k = 0;
    for (Integer const &integer : integers_) {
      for (; k < integer.first; ++k) merge_number(k, condition, yes, no);
      integer.merge(numbers_[k], condition, &yes[k], &no[k]);
      k += integer.words;
    }
    for (; k < numbers_.size(); ++k) merge_number(k, condition, yes, no);
  }

private:
  // A symbolic integer of one or more words: saved word by word, selected as a whole.
  struct Integer {
    std::size_t first, words;
    void (*merge)(void *object, SymbolicBool condition, void const *yes, void const *no);
  };
  template <class T> void integer(T &object) {
    constexpr std::size_t words = sizeof(T) / sizeof(RealNumber);
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(RealNumber) == 0);
    integers_.push_back(
        {numbers_.size(), words, [](void *into, SymbolicBool condition, void const *yes, void const *no) {
           T y, n;
           std::memcpy(&y, yes, sizeof y);
           std::memcpy(&n, no, sizeof n);
           *static_cast<T *>(into) = std::memcmp(yes, no, sizeof y) == 0 ? y : select(condition, y, n);
         }});
    for (std::size_t k = 0; k < words; ++k) numbers_.push_back(reinterpret_cast<RealNumber *>(&object) + k);
  }
  [[gnu::always_inline]] void merge_number(std::size_t k, SymbolicBool condition, List<RealNumber> const &yes,
                                           List<RealNumber> const &no) const {
    *numbers_[k] = yes[k].to_bits() == no[k].to_bits() ? yes[k] : select(condition, yes[k], no[k]);
  }

  List<RealNumber *> numbers_;
  List<Integer> integers_; // among them
  bool has_others_ = false;
};

// The statements of a function, or of one arm in it, of which some calls may have returned already.
struct Level {
  SymbolicBool path{true};      // path condition of the statements, from the function's entry
  SymbolicBool returned{false}; // condition under which one of them has returned
  OpenPathScope rest;

  void has_returned(SymbolicBool condition);
};

// Result of a function whose `return`s are selected. A template may be instantiated on a type with plain conditions.
class Returned {
public:
  Returned(RealNumber number, long double plain) noexcept : number_(number), plain_(plain) {}
  operator RealNumber() const noexcept { return number_; }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<T, RealNumber>>>
  operator T() const noexcept {
    return number_.is_node() ? static_cast<T>(number_) : static_cast<T>(plain_);
  }

private:
  RealNumber number_;
  long double plain_; // the value if no node is part of it, in the precision of its own type
};

// The returned value of a function whose `return`s depend on symbolic conditions: each `return` that is met in an arm
// is noted with its path, and the last one makes a select of them all.
class Returns {
public:
  Returns() = default;
  explicit Returns(FunctionKernel &kernel) : kernel_(&kernel) { kernel.defer_returned(true); }
  Returns(Returns const &) = delete;
  Returns &operator=(Returns const &) = delete;

  // `return value;`. True: symreal_result() is what the function returns.
  template <class T> [[gnu::always_inline]] bool symreal_leaves(T const &returned) {
    RealNumber const value(returned);
    plain_ = 0;
    if constexpr (!std::is_same_v<T, RealNumber> && std::is_arithmetic_v<T>)
      plain_ = static_cast<long double>(returned);
    else if (!value.is_node())
      plain_ = value.plain();
    if (level_ != &body_) {
      noted_.push_back({level_->path, value});
      level_->returned = true;
      return false;
    }
    fold(value);
    return true;
  }
  Returned symreal_result();
  // The function's end, met when every `return` was noted.
  [[gnu::always_inline]] Returned symreal_last() {
    fold(take_last());
    plain_ = result_.is_node() ? 0 : result_.plain();
    return symreal_result();
  }

private:
  friend class Branch;
  struct Noted {
    SymbolicBool path;
    RealNumber value;
  };
  [[gnu::always_inline]] void fold(RealNumber value) {
    for (std::size_t k = noted_.size(); k-- > 0;) value = select(noted_[k].path, noted_[k].value, value);
    result_ = value;
  }
  RealNumber take_last();

  FunctionKernel *kernel_ = nullptr;
  Level body_;
  Level *level_ = &body_;
  List<Noted> noted_;
  RealNumber result_{0.0};
  long double plain_ = 0;
};

// for (Branch branch(condition, ...); branch.symreal_more();) if (branch.symreal_arm()) ... else ...
class Branch {
public:
  template <class C, class Collect>
  [[gnu::always_inline]] Branch(C const &condition, Collect collect, Returns *returns = nullptr) {
    if constexpr (!is_symbolic_truth<C>) {
      outcome_ = static_cast<bool>(condition);
    } else {
      condition_ = symreal_truth(condition);
      is_select_ = condition_.is_symbolic() && detail::selects();
      if (is_select_) collect(targets_);
      is_select_ = is_select_ && !targets_.has_others();
      if (!is_select_) outcome_ = static_cast<bool>(condition_);
    }
    if (is_select_) returns_ = returns;
  }
  Branch(Branch const &) = delete;
  Branch &operator=(Branch const &) = delete;
  ~Branch();

  // True if another arm is to be executed.
  [[gnu::always_inline]] bool symreal_more() {
    ++stage_;
    if (!is_select_) return stage_ == 1;
    if (stage_ < 3) {
      stage_ == 1 ? begin_then() : begin_else();
      return true;
    }
    end_else();
    if (is_certain(then_returned_))
      ; // what is there now is what the other arm left
    else if (is_certain(else_returned_))
      targets_.restore(then_values_);
    else
      merge_arms();
    return false;
  }
  bool symreal_arm() const noexcept { return is_select_ ? stage_ == 1 : outcome_; }

private:
  static bool is_certain(SymbolicBool condition) noexcept { return !condition.is_symbolic() && condition.holds(); }
  void begin_then();
  void begin_else();
  void end_else();
  [[gnu::always_inline]] void merge_arms() {
    if (!foreign_.empty()) targets_.keep(foreign_, then_written_, before_);
    targets_.merge(condition_, then_values_, targets_.values());
  }
  void enter(SymbolicBool condition);
  SymbolicBool leave();

  SymbolicBool condition_{false};
  bool is_select_ = false, outcome_ = false;
  int stage_ = 0;
  Targets targets_;
  List<RealNumber> before_, then_values_;
  List<std::size_t> foreign_;
  List<bool> then_written_;
  OpenPathScope path_;
  Returns *returns_ = nullptr;
  Level *outer_ = nullptr;
  Level level_;
  SymbolicBool then_returned_{false}, else_returned_{false};
};

// A loop that runs at most so many times. It goes on as long as its condition may hold; what it assigns keeps its value
// once the condition no longer does.
class Loop {
public:
  // `late`: the condition is tested after the body.
  template <class Collect> Loop(unsigned limit, Collect collect, bool late = false) : limit_(limit), runs_(late) {
    collect(targets_);
    save();
  }
  Loop(Loop const &) = delete;
  Loop &operator=(Loop const &) = delete;
  [[gnu::always_inline]] ~Loop() { settle(); }

  // The loop's condition.
  template <class Test> [[gnu::always_inline]] bool symreal_test(Test condition) {
    settle();
    narrow(SymbolicBool(symreal_truth(condition())));
    if (is_over()) return false;
    if (runs_++ < limit_) return true;
    stop();
    return false;
  }
  // `if (condition) break;`: true if the loop has certainly ended.
  template <class C> [[gnu::always_inline]] bool symreal_breaks(C const &condition) {
    settle();
    narrow(!SymbolicBool(symreal_truth(condition)));
    return is_over();
  }

private:
  [[gnu::always_inline]] void settle() {
    if (active_.is_symbolic()) {
      if (!foreign_.empty()) targets_.keep(foreign_, List<bool>(foreign_.size(), false), saved_);
      targets_.merge(active_, targets_.values(), saved_);
    }
    save();
  }
  void save() {
    saved_ = targets_.values();
    foreign_ = targets_.foreign();
  }
  void narrow(SymbolicBool condition);
  bool is_over() const noexcept { return !active_.is_symbolic() && !active_.holds(); }
  // After the last run: the loop must have ended by then.
  void stop();

  unsigned limit_, runs_;
  Targets targets_;
  List<RealNumber> saved_;
  List<std::size_t> foreign_;
  SymbolicBool active_{true};
  OpenPathScope path_;
};

} // namespace symreal
