#include <string_view>
#include <vector>

#include "walkthroughs/page/page.hpp"

#ifdef GJKSTEP_SCRIPTS
// The scripts as the build has made them, among the constants.
#define GJKSTEP_HOLDS(name, file)           \
  asm(".section .rodata\n"                  \
      "gjkstep_" #name                      \
      "_begin:\n"                           \
      ".incbin \"" GJKSTEP_SCRIPTS "/" file \
      "\"\n"                                \
      "gjkstep_" #name                      \
      "_end:\n"                             \
      ".byte 0\n"                           \
      ".previous\n");                       \
  extern "C" const char gjkstep_##name##_begin[], gjkstep_##name##_end[];
GJKSTEP_HOLDS(few, "program.js")
GJKSTEP_HOLDS(all, "all-searches.js")
#endif

namespace walkthroughs::page {

const std::vector<PageFile>& page_programs() {
  static const std::vector<PageFile> scripts{
#ifdef GJKSTEP_SCRIPTS
      {"program.js", {gjkstep_few_begin, gjkstep_few_end}}, {"all-searches.js", {gjkstep_all_begin, gjkstep_all_end}}
#endif
  };
  return scripts;
}

}  // namespace walkthroughs::page
