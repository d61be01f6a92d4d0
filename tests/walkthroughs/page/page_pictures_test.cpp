#include "walkthroughs/page/page_pictures.hpp"

#include "tests/kit/catch.hpp"

using namespace walkthroughs;

TEST_CASE("A part of a picture fills the place of the whole") {
  CHECK(cut_out({1000, 500}, {{0, 0}, {1000, 500}}) ==
        "--width:100.000%;--left:-0.000%;--top:-0.000%;aspect-ratio:1000/500");
  CHECK(cut_out({1000, 500}, {{250, 100}, {750, 500}}) ==
        "--width:200.000%;--left:-50.000%;--top:-25.000%;aspect-ratio:500/400");
}

TEST_CASE("The text of a page is as large as that of its pictures") {
  CHECK(text_size(1).empty());
  CHECK(text_size(1.5) == "html{font-size:150.000%}");
}
