#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Canvas;
using render::Vec2;

constexpr double box_side = 15, box_left = 8, letter_left = 36,
                 choice_left = 64;             // units of words, of letters that are not scaled
constexpr double line_above = 4, between = 8;  // units of words

/// "b)"; those behind the alphabet go on with its capitals.
std::string letter_of(std::size_t choice) {
  return std::string(1, static_cast<char>(choice < 26 ? 'a' + choice : 'A' + choice - 26)) + ")";
}

/// Returns: how high it is.
double write_choice(Canvas& canvas, const Vec2& at, const std::string& letter, const std::string& text, double width,
                    const Style& style) {
  canvas.text(at + Vec2(style.scaled(letter_left), style.fact.size), letter, style.fact);
  const double left = style.scaled(choice_left);
  return write_lines(canvas, at + Vec2(left, 0), text, style.fact, width - left);
}

/// What is asked about one picture: the frame before the first of the answers.
struct Asked {
  std::size_t first;  ///< of all questions
  std::vector<Question> questions;
  std::size_t frame() const { return questions[0].frame - 1; }
};

/// Whether what comes on the sheet answers it: of a search that goes on the origin was crossed.
bool is_told(const Question& question) {
  return question.tells_before ||
         (question.decision.kind == Decision::Kind::crossing && question.decision.found == "crossed");
}

/// Whether it is seen in a picture alone that is not on the sheet, because it shows the answer. The edges of one face of a tetrahedron
/// are seen in its true shape, and in space whether the origin was crossed in the plane of d and OP.
bool is_out_of_sight(const Story& story, const Question& question) {
  using Kind = Decision::Kind;
  const Kind kind = question.decision.kind;
  if (kind == Kind::crossing) return story.tellings[question.scene].scene.dimension == Dimension::space;
  return question.decision.simplex_size == 4 && (kind == Kind::vertices || kind == Kind::direction);
}

/// In place of the walkthrough's title, which would tell how it ends.
std::string title_of(const Story& story) {
  const Scene& scene = story.tellings.front().scene;
  return "GJK of " + scene.a.name + ", " + scene.b.name + ": what will it find?";
}

bool is_of_one_picture(const Story& story, const Question& one, const Question& other) {
  const auto iteration = [&](const Question& question) {
    return story.frames[question.frame - 1].moments[question.scene].iteration;
  };
  return one.scene == other.scene && iteration(one) == iteration(other);
}

std::vector<Asked> by_pictures(const Story& story, const std::vector<Question>& all) {
  std::vector<Asked> pictures;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || !is_of_one_picture(story, all[i - 1], all[i])) pictures.push_back({i, {}});
    pictures.back().questions.push_back(all[i]);
  }
  return pictures;
}

/// Returns: how high it is.
double write_question(Canvas& canvas, double y, double width, std::size_t number, const Question& question,
                      const Style& style) {
  const double top = y;
  y += write_lines(canvas, {0, y}, std::to_string(number) + ". " + question.text, style.caption, width) + line_above;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const double left = style.scaled(box_left), right = left + style.scaled(box_side);
    const double bottom = y + style.fact.size, top_of_box = bottom - style.scaled(box_side);
    const Vec2 corners[] = {{left, bottom}, {right, bottom}, {right, top_of_box}, {left, top_of_box}};
    canvas.outline(corners, {style.theme.ink, 1.5});
    y += write_choice(canvas, {0, y}, letter_of(i), question.choices[i].text, width, style) + line_above;
  }
  return y - top;
}

double write_answer(Canvas& canvas, double width, const std::string& number, const Question& question,
                    const Style& style) {
  const Choice& right = question.choices[question.right];
  canvas.text({0, style.fact.size}, number, style.fact);
  const double y = write_choice(canvas, {0, 0}, letter_of(question.right), right.text, width, style);
  const double left = style.scaled(choice_left);
  return y + write_lines(canvas, {left, y}, right.reason, style.skipped, width - left);
}

void add_key(Printed& printed, const std::vector<Question>& all, const Style& style, render::Font& font) {
  Rows rows(printed);
  const auto head = [&](Canvas& canvas, double width) {
    return write_lines(canvas, {0, 0}, "Answers", style.title, width);
  };
  rows.write(head, style, font);
  for (std::size_t i = 0; i < all.size(); ++i)
    rows.write(
        [&](Canvas& canvas, double width) { return write_answer(canvas, width, std::to_string(i + 1), all[i], style); },
        style, font);
}

/// Not the simplex: what is kept is asked below the picture before.
std::string head_of(int iteration, bool is_first) {
  return "iteration " + std::to_string(iteration) +
         (is_first ? " · each picture tells what is asked above it: cover those below" : "");
}

Printed quiz_of(const StagedStory& story, const std::vector<Question>& all, Look look, render::Font& font) {
  look.values = false;
  std::vector<InGrid> parts;
  for (Asked& asked : by_pictures(story, all)) {
    const std::size_t frame = asked.frame();
    parts.push_back(
        {frame, [&story, &look, asked = std::move(asked), frame](Canvas& canvas, double width) {
           const auto& moment = story.frames[frame].moments[asked.questions[0].scene];
           double y = write_lines(canvas, {0, 0}, head_of(moment.iteration, asked.first == 0), look.style.small, width);
           for (std::size_t i = 0; i < asked.questions.size(); ++i)
             y += between +
                  write_question(canvas, y + between, width, asked.first + i + 1, asked.questions[i], look.style);
           return y;
         }});
  }
  Printed sheet = in_grid_on_a4(story, parts, look, font);
  add_key(sheet, all, look.style, font);
  add_heads_and_feet(sheet, literal(title_of(story)), look.style, font);
  return sheet;
}

}  // namespace

OneFile quiz(Unasked unasked) {
  const auto make = [unasked](const std::shared_ptr<const StagedStory>& story, const Output& output,
                              Renderer& renderer) -> Renderer::Content {
    const std::vector<Question> known = questions_of(*story);
    std::vector<Question> asked = in_frames(known, *story);
    const auto left_out =
        std::erase_if(asked, [&](const Question& each) { return is_told(each) || is_out_of_sight(*story, each); });
    if (asked.empty() || asked.size() + left_out < known.size()) unasked(*story, asked.size(), known.size() - left_out);
    if (asked.empty()) return {};
    return pdf_of(quiz_of(*story, asked, output.look, renderer.font()), {title_of(*story), ""},
                  output.look.style.theme.paper);
  };
  return {"quiz.pdf", make};
}

}  // namespace walkthroughs::output
