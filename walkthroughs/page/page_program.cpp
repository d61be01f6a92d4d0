#include <libdeflate.h>

#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <vector>

#include "render/html.hpp"
#include "walkthroughs/page/page.hpp"

#ifdef GJKSTEP_WASM_FOLDER
// The files as they are, among the constants.
#define GJKSTEP_HOLDS(name)                      \
  asm(".section .rodata\n"                       \
      "gjkstep_" #name                           \
      "_begin:\n"                                \
      ".incbin \"" GJKSTEP_WASM_FOLDER "/" #name \
      "-searches.wasm\"\n"                       \
      "gjkstep_" #name                           \
      "_end:\n"                                  \
      ".byte 0\n"                                \
      ".previous\n");                            \
  extern "C" const std::uint8_t gjkstep_##name##_begin[], gjkstep_##name##_end[];
GJKSTEP_HOLDS(few)
GJKSTEP_HOLDS(all)
#endif

namespace walkthroughs::page {
namespace {

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

[[maybe_unused]] std::string script(const std::string& name, std::span<const std::uint8_t> program) {
  return "'use strict';\nwindow." + name + " = '" + render::base64(deflated(program)) + "';\n";
}

}  // namespace

const std::vector<PageFile>& page_programs() {
  static const std::vector<PageFile> scripts{
#ifdef GJKSTEP_WASM_FOLDER
      {"program.js", script("gjkstepProgram", {gjkstep_few_begin, gjkstep_few_end})},
      {"all-searches.js", script("gjkstepAllSearches", {gjkstep_all_begin, gjkstep_all_end})}
#endif
  };
  return scripts;
}

}  // namespace walkthroughs::page
