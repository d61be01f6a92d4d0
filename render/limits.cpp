#include "render/limits.hpp"

#include <sys/resource.h>

namespace render {

std::string memory_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "";
  return "; only " + std::to_string(limit.rlim_cur >> 20) + " MiB of memory are allowed (ulimit -v), try with more";
}

}  // namespace render
