// In place of libFuzzer: every file of a directory once. replay DIRECTORY
#include "fuzzer.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  std::vector<std::filesystem::path> files;
  for (auto const &entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (std::filesystem::path const &file : files) {
    std::fprintf(stderr, "%s\n", file.c_str()); // the last line where the program ends here
    std::ifstream stream(file, std::ios::binary);
    std::string const text{std::istreambuf_iterator<char>(stream), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<std::uint8_t const *>(text.data()), text.size());
  }
  std::printf("%zu inputs\n", files.size());
}
