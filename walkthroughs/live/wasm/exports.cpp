// What a page calls. It writes a request where room_for() says, and reads the answer where text() says.
#include <string>

#include "walkthroughs/live/live.hpp"

namespace {

std::string request, answered;

walkthroughs::live::Live& live() {
  static render::Font font("");
  static walkthroughs::live::Live one(font);
  return one;
}

}  // namespace

extern "C" {

/// Returns: room for a request of so many bytes.
[[gnu::used, clang::export_name("room_for")]] char* room_for(std::size_t bytes) {
  request.resize(bytes);
  return request.data();
}

/// Returns: the length of the answer to what was written there.
[[gnu::used, clang::export_name("answer")]] std::size_t answer() {
  answered = live().answer(request);
  return answered.size();
}

[[gnu::used, clang::export_name("text")]] const char* text() { return answered.data(); }

}
