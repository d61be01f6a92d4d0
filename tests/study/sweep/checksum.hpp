/// A checksum that a JSON text carries as its last key: a byte that changed on the way is noticed, whatever it says now.
#pragma once

#include <string>
#include <string_view>

namespace study {

/// Returns: the object with one more key, "crc32", of all that stands before it. Requires: an object that has a key.
std::string with_checksum(std::string_view object);

/// Returns: whether with_checksum() has written this, and nothing of it has changed since.
bool has_its_checksum(std::string_view text);

}  // namespace study
