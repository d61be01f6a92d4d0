#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "render/html.hpp"
#include "walkthroughs/page/page.hpp"

#ifdef GJKSTEP_WASM
// The file as it is, among the constants.
asm(".section .rodata\n"
    ".balign 16\n"
    "gjkstep_wasm_begin:\n"
    ".incbin \"" GJKSTEP_WASM
    "\"\n"
    "gjkstep_wasm_end:\n"
    ".byte 0\n"
    ".previous\n");
extern "C" const std::uint8_t gjkstep_wasm_begin[], gjkstep_wasm_end[];
#endif

namespace walkthroughs::page {
namespace {

std::span<const std::uint8_t> program() {
#ifdef GJKSTEP_WASM
  return {gjkstep_wasm_begin, gjkstep_wasm_end};
#else
  return {};
#endif
}

/// As browsers unpack it: in the format of zlib.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
  constexpr int smallest = 12;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(smallest), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::vector<std::uint8_t> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
  return packed;
}

}  // namespace

const std::string& page_program() {
  static const std::string script =
      program().empty() ? ""
                        : "'use strict';\nwindow.gjkstepProgram = '" + render::base64(deflated(program())) + "';\n";
  return script;
}

}  // namespace walkthroughs::page
