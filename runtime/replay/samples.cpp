#include "runtime/replay/samples.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace symreal {

SampleSource::SampleSource(Graph const &graph, std::uint64_t seed, bool only_near)
    : guarded_(!graph.guards.empty()),
      only_near_(only_near),
      state_(seed) {
  auto slots = [](std::vector<Object> const &objects, std::vector<double> const &recorded) {
    std::vector<Slot> result;
    for (Object const &object : objects)
      for (std::uint32_t i = 0; i < object.count; ++i) {
        std::size_t slot = object.first + i;
        result.push_back({slot < recorded.size() && std::isfinite(recorded[slot]) ? recorded[slot] : 1, object.range});
      }
    return result;
  };
  inputs_ = slots(graph.inputs, graph.input_values);
  parameters_ = slots(graph.parameters, graph.parameter_values);
}

Sample SampleSource::next() {
  // Most samples lie near what the program was made for: far away, much code overflows.
  constexpr Way ways[] = {Way::near, Way::near, Way::near, Way::wide, Way::near, Way::corner};
  Way way = drawn_ == 0 ? Way::recorded : ways[(drawn_ - 1) % std::size(ways)];
  if (guarded_ && drawn_ % std::size(ways) == 2) way = Way::sparse;
  if (only_near_ && drawn_ != 0) way = Way::near;
  ++drawn_;
  Sample sample;
  for (Slot const &slot : inputs_) sample.inputs.push_back(draw(slot, way, false));
  // Parameters (masses, lengths) seldom make sense far from their values.
  for (Slot const &slot : parameters_) sample.parameters.push_back(draw(slot, way, true));
  return sample;
}

double SampleSource::draw(Slot const &slot, Way way, bool is_parameter) {
  if (way == Way::recorded) return slot.recorded;
  if (slot.range) return way == Way::corner ? corner(slot) : uniform(slot.range->low, slot.range->high);
  if (is_parameter || way == Way::near) return near(slot.recorded);
  if (way == Way::sparse) return bits() % 3 == 0 ? near(slot.recorded) : 0;
  return way == Way::wide ? wide() : corner(slot);
}

// Within a factor of two; a recorded zero says nothing about a magnitude.
double SampleSource::near(double recorded) {
  if (recorded == 0) return uniform(-2, 2);
  return recorded * std::exp2(uniform(-1, 1)) * (bits() % 8 == 0 ? -1 : 1);
}

double SampleSource::wide() {
  double magnitude = std::exp2(uniform(-30, 30));
  return bits() % 2 == 0 ? magnitude : -magnitude;
}

double SampleSource::corner(Slot const &slot) {
  constexpr double corners[] = {0, 1, -1, 0.5, -0.5, 2, 1.5707963267948966, 3.141592653589793, 1e-8, -1e8};
  double value = corners[bits() % std::size(corners)];
  // Two in three numbers are ordinary, so that a sample is not all corners.
  if (!slot.range) return bits() % 3 == 0 ? value : near(slot.recorded);
  switch (bits() % 3) {
  case 0: return slot.range->low;
  case 1: return slot.range->high;
  default: return std::clamp(value, slot.range->low, slot.range->high);
  }
}

// splitmix64: the standard library's distributions differ between hosts.
std::uint64_t SampleSource::bits() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

double SampleSource::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

} // namespace symreal
