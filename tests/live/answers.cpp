// Answers each line of standard input as the program in a page does: live.hpp.
#include <iostream>
#include <string>

#include "walkthroughs/live/live.hpp"

int main() {
  render::Font font(render::Font::default_directory());
  walkthroughs::live::Live live(font);
  for (std::string request; std::getline(std::cin, request);) std::cout << live.answer(request) << std::endl;
}
