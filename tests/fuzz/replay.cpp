/// In libFuzzer's place where that is absent: runs a fuzzer with each file of the folders that are named.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "render/file.hpp"

namespace fs = std::filesystem;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Which a fuzzer may call when it changes an input itself: here none is changed.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }

int main(int count, char** arguments) {
  std::vector<fs::path> files;
  for (int i = 1; i < count; ++i) files.insert(files.end(), fs::directory_iterator(arguments[i]), {});
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    std::printf("%s\n", file.c_str());  // the last one named is the one that failed
    std::fflush(stdout);
    const std::vector<std::uint8_t> bytes = render::read_file(file);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return files.empty();
}
