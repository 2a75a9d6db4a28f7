#include "analysis/scheduling/exact.h"

#include "analysis/scheduling/seen_states.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>

namespace symreal {
namespace {

using Set = std::uint64_t;
Set one(TaskId task) { return Set{1} << task; }

template <class Visit> void for_each(Set set, Visit visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<TaskId>(std::countr_zero(set)));
}

class Search {
public:
  Search(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
         std::uint64_t most_nodes)
      : network_(network),
        units_(units),
        tail_(windows.tail),
        best_(below),
        enough_(enough),
        most_nodes_(most_nodes),
        all_(network.size() == 64 ? ~Set{0} : one(static_cast<TaskId>(network.size())) - 1),
        free_(units.count),
        seen_(std::min<std::size_t>(network.size() + 4, most_nodes < 1'000'000 ? 16 : 20)),
        start_(network.size()),
        head_(network.size()) {
    order_tasks();
    find_twins();
  }

  ExactResult run() {
    enter(0, 0, 0);
    return {best_start_, !is_over_limit_, nodes_};
  }

private:
  void order_tasks() {
    by_tail_.resize(network_.size());
    std::iota(by_tail_.begin(), by_tail_.end(), TaskId{0});
    std::ranges::stable_sort(by_tail_, std::greater<>(), [&](TaskId task) { return tail_[task]; });
    by_urgency_ = by_tail_;
    // Those that must not be left behind come first: also where the urgency is the same.
    std::ranges::sort(by_urgency_, {}, [&](TaskId task) {
      return std::tuple(-tail_[task] - network_.duration[task], -static_cast<Time>(network_.after.of(task).size()),
                        task);
    });
  }

  void find_twins() {
    std::vector<Set> after(network_.size());
    before_.resize(network_.size());
    first_.resize(network_.size());
    for (TaskId task = 0; task < network_.size(); ++task) {
      for (TaskId other : network_.after.of(task)) after[task] |= one(other);
      for (TaskId other : network_.before.of(task)) before_[task] |= one(other);
    }
    for (TaskId a = 0; a < network_.size(); ++a)
      for (TaskId b = 0; b < network_.size(); ++b)
        if (a != b && network_.duration[a] == network_.duration[b] && network_.kind[a] == network_.kind[b] &&
            (after[a] & after[b]) == after[b] && (after[a] != after[b] || a < b))
          first_[b] |= one(a);
    longer_.resize(network_.size());
    could_change_.resize(network_.size());
    for (TaskId a = 0; a < network_.size(); ++a)
      for (TaskId b = 0; b < network_.size(); ++b)
        if (network_.duration[a] < network_.duration[b] && network_.kind[a] == network_.kind[b] &&
            (after[a] & after[b]) == after[a])
          longer_[a] |= one(b);
  }

  bool is_over() const { return is_over_limit_ || best_ <= enough_; }

  // At a time when something has ended. `held_back` could have begun before and may not begin now.
  void enter(Time now, Set ended, Set held_back) {
    for (Set instant = 1; instant != 0;) {
      instant = ready(ended) & ~started_ & instants_of(ended);
      for_each(instant, [&](TaskId task) { start_[task] = now; });
      ended |= instant;
    }
    Set const started_before = started_;
    started_ |= ended;
    if (ended == all_) {
      if (now < best_) best_start_ = start_, best_ = now;
    } else if (++nodes_ > most_nodes_) {
      is_over_limit_ = true;
    } else if (!is_hopeless(now, ended) && !seen_.was_seen(key(now, ended, held_back), now)) {
      begin_some(now, ended, held_back, 0);
    }
    started_ = started_before;
  }

  Set ready(Set ended) const {
    Set result = 0;
    for_each(all_ & ~ended, [&](TaskId task) {
      if ((before_[task] & ~ended) == 0) result |= one(task);
    });
    return result;
  }
  Set instants_of(Set ended) const {
    Set result = 0;
    for_each(all_ & ~ended, [&](TaskId task) {
      if (network_.duration[task] == 0) result |= one(task);
    });
    return result;
  }

  StateKey key(Time now, Set ended, Set held_back) const {
    StateKey result;
    result.add(ended);
    result.add(held_back);
    for_each(started_ & ~ended, [&](TaskId task) {
      result.add(task);
      result.add(static_cast<std::uint64_t>(end_of(task) - now));
      result.add(could_change_[task] & ~started_);
    });
    return result;
  }

  // Decides on the ready tasks from place `from` of the order of urgency on, then lets time go on.
  void begin_some(Time now, Set ended, Set held_back, std::size_t from) {
    if (is_over()) return;
    Set const can_begin = ready(ended) & ~started_;
    for (std::size_t i = from; i < by_urgency_.size(); ++i) {
      TaskId const task = by_urgency_[i];
      if (!(can_begin & ~held_back & one(task)) || free_[network_.kind[task]] == 0 || (first_[task] & can_begin))
        continue;
      start_[task] = now;
      could_change_[task] = longer_[task] & can_begin;
      started_ |= one(task);
      --free_[network_.kind[task]];
      begin_some(now, ended, held_back, i + 1);
      ++free_[network_.kind[task]];
      started_ &= ~one(task);
      if (is_over()) return;
    }
    go_on(ended, can_begin);
  }

  void go_on(Set ended, Set can_begin) {
    Set const running = started_ & ~ended;
    if (running == 0) return;
    Time next = end_of(static_cast<TaskId>(std::countr_zero(running)));
    for_each(running, [&](TaskId task) { next = std::min(next, end_of(task)); });
    if (next >= best_) return;
    Set held_back = 0, ending = 0;
    for_each(can_begin & ~started_, [&](TaskId task) {
      if (free_[network_.kind[task]] != 0) held_back |= one(task);
    });
    for_each(running, [&](TaskId task) {
      if (end_of(task) == next) ending |= one(task);
    });
    for_each(ending, [&](TaskId task) { ++free_[network_.kind[task]]; });
    for_each(ending, [&](TaskId task) { held_back |= could_change_[task] & ~started_; });
    enter(next, ended | ending, held_back);
    for_each(ending, [&](TaskId task) { --free_[network_.kind[task]]; });
  }

  // Whether some interval has too much work for a timetable that is shorter than the best.
  bool is_hopeless(Time now, Set ended) {
    std::array<Time, most_exact_tasks> begins;
    std::size_t count = 0;
    for (TaskId task = 0; task < network_.size(); ++task) {
      if (ended & one(task)) continue;
      if (started_ & one(task)) {
        head_[task] = now; // with what is left of it
      } else {
        head_[task] = now;
        for_each(before_[task] & ~ended, [&](TaskId other) { head_[task] = std::max(head_[task], head_end(other)); });
      }
      if (head_end(task) + tail_[task] >= best_) return true;
      begins[count++] = head_[task];
    }
    std::sort(begins.begin(), begins.begin() + count);
    count = static_cast<std::size_t>(std::unique(begins.begin(), begins.begin() + count) - begins.begin());
    for (std::size_t i = 0; i < count; ++i)
      if (is_too_much(begins[i], ended)) return true;
    return false;
  }

  bool is_too_much(Time begin, Set ended) {
    work_.assign(units_.count.size(), 0);
    for (TaskId task : by_tail_) {
      if (ended & one(task)) continue;
      Time const within = std::min(head_end(task) - std::max(begin, head_[task]), head_end(task) - begin);
      if (within <= 0) continue;
      std::size_t const kind = network_.kind[task];
      work_[kind] += within;
      if (work_[kind] > static_cast<Time>(units_.count[kind]) * (best_ - 1 - begin - tail_[task])) return true;
    }
    return false;
  }

  Time end_of(TaskId task) const { return start_[task] + network_.duration[task]; }
  Time head_end(TaskId task) const {
    return started_ & one(task) ? end_of(task) : head_[task] + network_.duration[task];
  }

  Network const &network_;
  Units const &units_;
  std::vector<Time> const &tail_;
  Time best_, enough_;
  std::uint64_t most_nodes_, nodes_ = 0;
  bool is_over_limit_ = false;
  Set all_, started_ = 0;
  std::vector<unsigned> free_; // units, per kind
  SeenStates seen_;
  std::vector<Time> start_, head_, best_start_, work_;
  std::vector<Set> before_;
  std::vector<Set> first_;        // those that must not be ready and unstarted when it begins
  std::vector<Set> longer_;       // those that could change places with it, if ready when it begins
  std::vector<Set> could_change_; // those of them that were
  std::vector<TaskId> by_tail_, by_urgency_;
};

} // namespace

ExactResult search_exactly(Network const &network, Units const &units, Windows const &windows, Time below, Time enough,
                           std::uint64_t most_nodes) {
  return Search(network, units, windows, below, enough, most_nodes).run();
}

} // namespace symreal
