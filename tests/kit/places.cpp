#include "tests/kit/places.hpp"

namespace kit {

std::filesystem::path program() { return KIT_PROGRAM; }
std::filesystem::path source(const std::filesystem::path& path) { return std::filesystem::path(KIT_SOURCE) / path; }
std::filesystem::path built(const std::filesystem::path& path) { return std::filesystem::path(KIT_BUILT) / path; }

}  // namespace kit
