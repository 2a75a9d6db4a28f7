// Structs with the shapes of the annotated objects, and spans, call the functions on arrays.
// RUN: rm -rf %t && mkdir %t
// RUN: %symreal generate %source/tests/cpp/Inputs/bodies.cpp --lang=cpp --prefix=plant -o %t/plant.cpp
// RUN: FileCheck %s --input-file=%t/plant.hpp
// CHECK: namespace plant {
// CHECK: struct Input {
// CHECK-NEXT:   struct {
// CHECK-NEXT:     double mass;
// CHECK-NEXT:     double at[2];
// CHECK-NEXT:   } bodies[2];
// CHECK: struct Parameters {
// CHECK-NEXT:   double g;
// RUN: g++ -std=c++17 -I%t -Wall -Wextra -Wconversion -Wshadow -Werror %s %t/plant.cpp -o %t/seventeen && %t/seventeen
// RUN: clang++-19 -std=c++20 -I%t -Wall -Wextra -Wconversion -Wshadow -Werror %s %t/plant.cpp -o %t/twenty && %t/twenty
#include "plant.hpp"

#include <array>

int main() {
  plant::Input input{};
  input.bodies[1].mass = 3;
  input.bodies[1].at[0] = 2;
  plant::Parameters parameters{9.5};
  plant::Constants constants{};
  plant::Output output{};
  plant::preprocess(parameters, constants);
  plant::compute(input, constants, output);
  if (output.moment[0] != 3 * 2 * 9.5) return 1;
#if __cplusplus >= 202002L
  std::array<double, plant::input_count> numbers{};
  numbers[plant::input_bodies + 3] = 3;
  numbers[plant::input_bodies + 4] = 2;
  std::array<double, plant::constant_count> precomputed{};
  std::array<double, plant::output_count> result{};
  plant::preprocess(std::array{9.5}, precomputed);
  plant::compute(numbers, precomputed, result);
  if (result[0] != output.moment[0]) return 2;
#endif
  return 0;
}
