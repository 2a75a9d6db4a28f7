#include "engine/analysis/scheduling/packing.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <unordered_set>

namespace symreal {
namespace {

using Set = std::uint64_t;

class PackingSearch {
public:
  PackingSearch(std::vector<Time> const &duration, unsigned units, Time capacity, std::uint64_t most_nodes)
      : capacity_(capacity),
        units_(units),
        nodes_left_(most_nodes),
        order_(duration.size()),
        unit_(duration.size()),
        failed_(units + 1) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {}, [&](std::size_t i) { return std::pair(-duration[i], i); });
    for (std::size_t i : order_) duration_.push_back(duration[i]);
  }

  Packing run() {
    Set const all = duration_.empty() ? 0 : ~Set{0} >> (64 - duration_.size());
    Time const work = std::accumulate(duration_.begin(), duration_.end(), Time{0});
    if (!duration_.empty() && duration_[0] > capacity_) return {Packing::Fits::no, {}};
    if (begin_unit(units_, all, static_cast<Time>(units_) * capacity_ - work)) {
      std::vector<unsigned> unit(order_.size());
      for (std::size_t i = 0; i < order_.size(); ++i) unit[order_[i]] = unit_[i];
      return {Packing::Fits::yes, std::move(unit)};
    }
    return {nodes_left_ == 0 ? Packing::Fits::unknown : Packing::Fits::no, {}};
  }

private:
  static std::size_t first(Set set) { return static_cast<std::size_t>(std::countr_zero(set)); }

  // Packs `left` on `units` units; `spare` is the time that may stay unused.
  bool begin_unit(unsigned units, Set left, Time spare) {
    if (left == 0) return true;
    if (units == 0 || spare < 0 || failed_[units].contains(left)) return false;
    std::size_t const longest = first(left);
    unit_[longest] = units - 1;
    if (fill(units, left & (left - 1), left & (left - 1), capacity_ - duration_[longest], spare)) return true;
    if (nodes_left_ != 0 && failed_[units].size() < 100'000) failed_[units].insert(left);
    return false;
  }

  // Fills the current unit, which has the time `room` left; `choice` are the candidates among `left`.
  bool fill(unsigned units, Set left, Set choice, Time room, Time spare) {
    if (nodes_left_ == 0 || --nodes_left_ == 0) return false;
    Time refused = -1; // duration of the last refused task; equal ones would fail too
    for (; choice != 0; choice &= choice - 1) {
      std::size_t const task = first(choice);
      if (duration_[task] > room || duration_[task] == refused) continue;
      unit_[task] = units - 1;
      Set const one = Set{1} << task;
      if (fill(units, left & ~one, choice & ~one, room - duration_[task], spare)) return true;
      refused = duration_[task];
    }
    if (room > spare) return false;
    if (left != 0 && duration_[63 - static_cast<std::size_t>(std::countl_zero(left))] <= room) return false;
    return begin_unit(units - 1, left, spare - room);
  }

  Time capacity_;
  unsigned units_;
  std::uint64_t nodes_left_;
  std::vector<Time> duration_; // descending
  std::vector<std::size_t> order_;
  std::vector<unsigned> unit_;
  std::vector<std::unordered_set<Set>> failed_; // by unit count: sets that did not fit
};

std::vector<Time> distinct(std::vector<Time> times) {
  std::ranges::sort(times);
  times.erase(std::ranges::unique(times).begin(), times.end());
  return times;
}

} // namespace

Packing pack(std::vector<Time> const &duration, unsigned units, Time capacity, std::uint64_t most_nodes) {
  return PackingSearch(duration, units, capacity, most_nodes).run();
}

Time packing_bound(Network const &network, Units const &units, Windows const &windows, Time length, Time enough) {
  std::vector<Time> within;
  for (std::size_t kind = 0; kind < units.count.size(); ++kind)
    for (Time head : distinct(windows.head))
      for (Time tail : distinct(windows.tail)) {
        within.clear();
        for (TaskId task = 0; task < network.size(); ++task)
          if (network.kind[task] == kind && windows.head[task] >= head && windows.tail[task] >= tail &&
              network.duration[task] != 0)
            within.push_back(network.duration[task]);
        if (within.size() <= units.count[kind]) continue;
        while (length < enough && pack(within, units.count[kind], length - head - tail, 3000).fits == Packing::Fits::no)
          ++length;
      }
  return length;
}

IndependentPacking pack_independent(Network const &network, Units const &units, Time at_least, Time below) {
  IndependentPacking result{{}, at_least};
  std::vector<Time> start(network.size());
  for (; result.at_least < below; ++result.at_least) {
    bool fits = true;
    for (std::size_t kind = 0; kind < units.count.size() && fits; ++kind) {
      std::vector<TaskId> tasks;
      std::vector<Time> duration, busy(units.count[kind]);
      for (TaskId task = 0; task < network.size(); ++task)
        if (network.kind[task] == kind) tasks.push_back(task), duration.push_back(network.duration[task]);
      Packing const packing = pack(duration, units.count[kind], result.at_least, 1'000'000);
      if (packing.fits == Packing::Fits::unknown) return result;
      fits = packing.fits == Packing::Fits::yes;
      for (std::size_t i = 0; i < tasks.size() && fits; ++i) {
        start[tasks[i]] = busy[packing.unit[i]];
        busy[packing.unit[i]] += duration[i];
      }
    }
    if (!fits) continue;
    result.start = std::move(start);
    break;
  }
  return result;
}

} // namespace symreal
