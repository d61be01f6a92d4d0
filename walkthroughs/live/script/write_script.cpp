// A program for pages as a script, so that no run of gjkstep packs it anew: sets window.NAME to base64 of it, deflated.
//   write-script NAME PROGRAM.wasm SCRIPT
#include <libdeflate.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "render/html.hpp"

namespace {

/// As browsers unpack it: in the format of zlib. Returns: nothing where there is no memory.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
  constexpr int smallest = 12;
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(smallest);
  if (compressor == nullptr) return {};
  std::vector<std::uint8_t> packed(libdeflate_zlib_compress_bound(compressor, bytes.size()));
  packed.resize(libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), packed.data(), packed.size()));
  libdeflate_free_compressor(compressor);
  return packed;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  std::ifstream program(words[2], std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(program), {}};
  const std::vector<std::uint8_t> packed = deflated(bytes);
  std::ofstream script(words[3], std::ios::binary);
  script << "'use strict';\nwindow." << words[1] << " = '" << render::base64(packed) << "';\n" << std::flush;
  if (!bytes.empty() && !packed.empty() && script) return 0;
  std::cerr << "write-script: cannot make " << words[3] << " of " << words[2] << '\n';
  return 1;
}
