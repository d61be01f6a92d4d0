#include "walkthroughs/wrong_on_purpose/measured.hpp"

#include <stdexcept>
#include <vector>

#include "walkthroughs/wrong_on_purpose/measured_rows.hpp"

namespace walkthroughs::wrong_on_purpose {
namespace {

/// Returns: what stands between the bars.
std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  for (std::size_t bar = row.find('|'); bar != std::string_view::npos;) {
    const std::size_t next = row.find('|', bar + 1);
    if (next != std::string_view::npos) cells.emplace_back(row.substr(bar + 1, next - bar - 1));
    bar = next;
  }
  return cells;
}

/// Of " 190,000 (120,000–300,000) " or " more than 780,000 ".
PairsToNotice read(const std::string& cell) {
  constexpr std::string_view more = " more than ";
  PairsToNotice read{0, cell.starts_with(more)};
  for (const char c : cell.substr(read.is_more ? more.size() : 1)) {
    if (c >= '0' && c <= '9') read.count = 10 * read.count + (c - '0');
    if (c == ' ') break;
  }
  return read;
}

std::vector<std::vector<PairsToNotice>> read_all() {
  std::vector<std::vector<PairsToNotice>> all;
  for (std::string_view rest = measured_rows; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::vector<std::string> cells = cells_of(rest.substr(0, end));
    if (cells.size() == 8 && cells[0] == " " + number_of(static_cast<Mistake>(all.size())) + " ")
      all.push_back({read(cells[5]), read(cells[6]), read(cells[7])});
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (all.size() != wrong_on_purpose::all().size())
    throw std::logic_error("the study's table of mistakes has another form than this program reads");
  return all;
}

}  // namespace

std::string PairsToNotice::text() const {
  std::string digits = std::to_string(static_cast<long long>(count));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return (is_more ? "more than " : "about ") + digits;
}

PairsToNotice pairs_to_notice(Mistake mistake, TestPairs pairs) {
  static const std::vector<std::vector<PairsToNotice>> known = read_all();
  return known.at(static_cast<std::size_t>(mistake)).at(static_cast<std::size_t>(pairs));
}

bool is_none_along_axes(Mistake mistake) { return mistake == Mistake::first_point_tested; }

}  // namespace walkthroughs::wrong_on_purpose
