// The same with strings and streams of C++.
// RUN: %same %s
// RUN: not %symreal generate %s -o %t.c --kernel=strings --run-args=strings 2>&1 | FileCheck %s
// RUN: not %symreal generate %s -o %t.c --kernel=streams --run-args=streams 2>&1 | FileCheck %s --check-prefix=STREAMS
// RUN: not %symreal generate %s -o %t.c --kernel=keys --run-args=keys 2>&1 | FileCheck %s --check-prefix=KEYS
// RUN: not ls %t.c
#include <charconv>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <unordered_map>

#pragma symreal function input(x) output(return)
double strings(double x) {
  std::string const s = std::to_string(x);
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:24: error: 's' is read, which holds the text of x [SYM143]
  double y = std::stod(s);
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:7: error: 's' is read, which holds the text of x [SYM143]
  if (s[0] == '-') y += 1;
  std::string const t = "x is " + s;
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:8: error: 't' is read, which holds the text of x [SYM143]
  y += t.size();
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:7: error: 't' is read, which holds the text of x [SYM143]
  if (t != "x is 5.300000") y += 1;
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:17: error: 's' is read, which holds the text of x [SYM143]
  for (char c : s) y += c;
  char const *p = s.c_str();
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:8: error: 'p[2]' is read, which holds the text of x [SYM143]
  y += p[2];
  char b[40];
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:21: error: the length that is used here is that of the text of x [SYM143]
  char *const end = std::to_chars(b, b + sizeof b, x).ptr;
  int z = 0;
  // CHECK: strings_read_back.cpp:[[@LINE+1]]:19: error: 'b' is read, which holds the text of x [SYM143]
  std::from_chars(b, end, z);
  return x + y + z;
}

#pragma symreal function input(x) output(return)
double streams(double x) {
  std::ostringstream out;
  out.precision(3);
  out << "v " << x << ' ' << 2 * x;
  std::istringstream in(out.str());
  std::string word;
  double y = 0, z = 0;
  // STREAMS: strings_read_back.cpp:[[@LINE+1]]:3: error: 'in' is read, which holds the text of {{.*}} [SYM143]
  in >> word >> y;
  std::stringstream both;
  both << x;
  // STREAMS: strings_read_back.cpp:[[@LINE+1]]:3: error: 'both' is read, which holds the text of x [SYM143]
  both >> z;
  std::ofstream("number.txt") << x << '\n';
  std::ifstream file("number.txt");
  // STREAMS: strings_read_back.cpp:[[@LINE+1]]:21: error: 'file' is read, which holds the text of x [SYM143]
  if (!std::getline(file, word)) return 0;
  return x + y + z;
}

#pragma symreal function input(x) output(return)
double keys(double x) {
  std::map<std::string, int> cache;
  // KEYS: strings_read_back.cpp:[[@LINE+1]]:9: error: 'std::to_string(x)' is read, which holds the text of x [SYM143]
  cache[std::to_string(x)] = 2;
  std::unordered_map<std::string, int> other;
  std::string const key = "key " + std::to_string(x);
  // KEYS: strings_read_back.cpp:[[@LINE+1]]:18: error: 'key' is read, which holds the text of x [SYM143]
  if (other.find(key) == other.end()) x += 1;
  // KEYS: strings_read_back.cpp:[[@LINE+1]]:35: error: 'key' is read, which holds the text of x [SYM143]
  return std::hash<std::string>{}(key) % 7 * x;
}

int main(int, char **arguments) {
  std::string const kernel = arguments[1];
  if (kernel == "strings") std::printf("%g\n", strings(5.3));
  if (kernel == "streams") std::printf("%g\n", streams(5.3));
  if (kernel == "keys") std::printf("%g\n", keys(5.3));
}
