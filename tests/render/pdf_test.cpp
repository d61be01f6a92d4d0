#include "render/pdf.hpp"

#include <string_view>

#include "tests/kit/catch.hpp"

using namespace render;

namespace {

std::vector<std::uint8_t> file_of(int pages) {
  Pdf pdf({"pages", ""});
  for (int i = 0; i < pages; ++i) pdf.add(Image({16, 32}), {100, 200});
  return pdf.finish();
}

}  // namespace

TEST_CASE("pictures become a PDF file, the same each time, which grows with its pages") {
  const std::vector<std::uint8_t> file = file_of(2);
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  CHECK(text.starts_with("%PDF-"));
  CHECK(text.ends_with("%%EOF\n"));
  CHECK(file == file_of(2));
  CHECK(file_of(3).size() > file.size() + 100);
}
