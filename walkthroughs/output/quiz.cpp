#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Canvas;
using render::Vec2;

constexpr double box_side = 15, box_left = 8, letter_left = 36, choice_left = 64, line_above = 4;  // units of words

/// "b)"; those behind the alphabet go on with its capitals.
std::string letter_of(std::size_t choice) {
  return std::string(1, static_cast<char>(choice < 26 ? 'a' + choice : 'A' + choice - 26)) + ")";
}

/// Returns: how high it is.
double write_choice(Canvas& canvas, const Vec2& at, const std::string& letter, const std::string& text, double width,
                    const Style& style) {
  canvas.text(at + Vec2(letter_left, style.fact.size), letter, style.fact);
  return write_lines(canvas, at + Vec2(choice_left, 0), text, style.fact, width - choice_left);
}

double write_question(Canvas& canvas, double width, const std::string& where, const Question& question,
                      const Style& style) {
  double y = write_lines(canvas, {0, 0}, where, style.small, width);
  y += write_lines(canvas, {0, y}, question.text, style.caption, width) + line_above;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const double side = style.scaled(box_side), bottom = y + style.fact.size;
    const Vec2 corners[] = {
        {box_left, bottom}, {box_left + side, bottom}, {box_left + side, bottom - side}, {box_left, bottom - side}};
    canvas.outline(corners, {style.theme.ink, 1.5});
    y += write_choice(canvas, {0, y}, letter_of(i), question.choices[i].text, width, style) + line_above;
  }
  return y;
}

double write_answer(Canvas& canvas, double width, const std::string& number, const Question& question,
                    const Style& style) {
  const Choice& right = question.choices[question.right];
  canvas.text({0, style.fact.size}, number, style.fact);
  const double y = write_choice(canvas, {0, 0}, letter_of(question.right), right.text, width, style);
  return y + write_lines(canvas, {choice_left, y}, right.reason, style.skipped, width - choice_left);
}

void add_key(Printed& printed, const std::vector<Question>& all, const Style& style, render::Font& font) {
  Rows rows(printed);
  const auto head = [&](Canvas& canvas, double width) {
    return write_lines(canvas, {0, 0}, "Answers", style.title, width);
  };
  rows.write(head, style, font);
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.write([&](Canvas& canvas,
                   double width) { return write_answer(canvas, width, std::to_string(i + 1), all[i], style); },
               style, font);
}

Printed quiz_of(const StagedStory& story, const std::vector<Question>& all, Look look, render::Font& font) {
  look.values = false;
  std::vector<InGrid> parts;
  for (std::size_t i = 0; i < all.size(); ++i)
    parts.push_back({all[i].frame - 1, [&, i](Canvas& canvas, double width) {
                       const std::string where =
                           "question " + std::to_string(i + 1) + " · " + state_in_words(story, all[i].frame - 1);
                       return write_question(canvas, width, where, all[i], look.style);
                     }});
  Printed sheet = in_grid_on_a4(story, parts, look, font);
  add_key(sheet, all, look.style, font);
  // Its title would tell how it ends.
  add_heads_and_feet(sheet, "What will the search find? Cover what stands below: it tells.", look.style, font);
  return sheet;
}

}  // namespace

OneFile quiz(Unasked unasked) {
  const auto make = [unasked](const std::shared_ptr<const StagedStory>& story, const Output& output,
                              Renderer& renderer) -> Renderer::Content {
    const std::vector<Question> known = questions_of(*story);
    const std::vector<Question> asked = in_frames(known, *story);
    if (asked.empty() || asked.size() < known.size()) unasked(*story, asked.size(), known.size());
    if (asked.empty()) return {};
    return pdf_of(quiz_of(*story, asked, output.look, renderer.font()), *story, output.look.style.theme.paper);
  };
  return {"quiz.pdf", make};
}

}  // namespace walkthroughs::output
