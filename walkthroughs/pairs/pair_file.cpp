#include "walkthroughs/pairs/pair_file.hpp"

#include <span>
#include <stdexcept>
#include <string>

namespace walkthroughs::pairs {
namespace {

constexpr std::size_t longest_pair = std::size_t{64} << 20;

}  // namespace

PairFile::PairFile(const std::filesystem::path& file)
    : called_(text::called(file)),
      file_(file),
      lines_([this](std::span<char> bytes) { return read_some(bytes); }, longest_pair) {}

std::size_t PairFile::read_some(std::span<char> bytes) {
  if (without_end_ > longest_pair) refuse_line("is longer than 64 MiB; give pairs, one a line");
  const std::size_t count = file_.read_some(bytes);
  without_end_ += count;
  return count;
}

void PairFile::refuse_line(const std::string& why) const {
  throw text::InputError(called_ + ":" + std::to_string(number_) + ": " + why);
}

std::optional<NamedPair> PairFile::next() {
  ++number_;
  without_end_ = 0;
  const auto line = lines_.next();
  if (!line && number_ == 1)
    throw text::InputError(called_ + R"(: holds no pair; each is a line {"a":{"points":[[0,0,0]]},"b":…})");
  if (!line) return std::nullopt;
  try {
    return pair_of_line(line->text, "line-" + std::to_string(number_));
  } catch (const std::invalid_argument& error) {
    refuse_line(error.what());
  }
}

}  // namespace walkthroughs::pairs
