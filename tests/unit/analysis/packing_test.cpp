#include "engine/analysis/scheduling/packing.h"

#include "exhaustive.h"
#include "random_graphs.h"

#include <gtest/gtest.h>
#include <numeric>

namespace symreal {
namespace {

bool fits_somehow(std::vector<Time> const &duration, std::vector<Time> &room, std::size_t task) {
  if (task == duration.size()) return true;
  for (Time &each : room) {
    if (each < duration[task]) continue;
    each -= duration[task];
    bool const fits = fits_somehow(duration, room, task + 1);
    each += duration[task];
    if (fits) return true;
  }
  return false;
}

TEST(Packing, fits_when_some_assignment_does) {
  Random random(21);
  unsigned fitting = 0, others = 0;
  for (unsigned i = 0; i < 500; ++i) {
    std::vector<Time> duration;
    for (unsigned k = 0; k < 3 + i % 6; ++k) duration.push_back(static_cast<Time>(random.below(12)));
    unsigned const units = 2 + i % 3;
    Time const work = std::accumulate(duration.begin(), duration.end(), Time{0});
    Time const capacity = work / units + static_cast<Time>(random.below(3));
    Packing const packing = pack(duration, units, capacity, 1'000'000);
    std::vector<Time> room(units, capacity), busy(units);
    bool const fits = fits_somehow(duration, room, 0);
    EXPECT_EQ(packing.fits, fits ? Packing::Fits::yes : Packing::Fits::no);
    ++(fits ? fitting : others);
    for (std::size_t task = 0; task < packing.unit.size(); ++task) busy[packing.unit[task]] += duration[task];
    EXPECT_LE(*std::ranges::max_element(busy), capacity);
  }
  EXPECT_GT(fitting, 50u);
  EXPECT_GT(others, 50u);
}

TEST(Packing, gives_a_bound_that_no_timetable_is_below) {
  Random random(22);
  unsigned raised = 0;
  for (unsigned i = 0; i < 100; ++i) {
    TaskGraph const graph = random_graph({TaskId(5 + i % 4), 10, 6}, random);
    Units const units{{2 + i % 3}};
    Network const network = make_network(graph);
    Time const optimum = EveryStep(graph, units).shortest();
    Time const bound = packing_bound(network, units, windows(network, units), 0, 1000);
    EXPECT_LE(bound, optimum) << "graph " << i;
    raised += bound == optimum;
  }
  EXPECT_GT(raised, 30u);
}

} // namespace
} // namespace symreal
