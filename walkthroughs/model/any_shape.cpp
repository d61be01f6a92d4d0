#include "walkthroughs/model/any_shape.hpp"

namespace walkthroughs::model {
namespace {

std::string_view name_of(const AnyShape& shape, Dimension dimension) {
  const auto name = [&](const auto& one) {
    using Named = RowOf<decltype(one)>;
    return dimension == Dimension::plane ? Named::kind_in_plane : Named::kind;
  };
  return std::visit(name, shape);
}

struct Description {
  Dimension dimension;

  std::string operator()(const Points& points) const {
    return std::to_string(points.size()) + (points.size() == 1 ? " point" : " points");
  }
  std::string operator()(const Sum& sum) const {
    const auto with_article = [&](const AnyShape& summand) {
      return (std::holds_alternative<Points>(summand) ? "" : "a ") + std::visit(*this, summand);
    };
    return "sum of " + with_article(sum.summands[0]) + " and " + with_article(sum.summands[1]);
  }
  std::string operator()(const auto& one) const { return std::string(name_of(AnyShape(one), dimension)); }
};

}  // namespace

std::string_view key_of(const AnyShape& shape) {
  return std::visit([](const auto& one) { return RowOf<decltype(one)>::key; }, shape);
}

std::string kind_of(const AnyShape& shape, Dimension dimension) {
  std::string kind(name_of(shape, dimension));
  if (const auto* sum = std::get_if<Sum>(&shape))
    kind.append(" of a ")
        .append(name_of(sum->summands[0], dimension))
        .append(" and a ")
        .append(name_of(sum->summands[1], dimension));
  return kind;
}

std::string shapes_in_lines(const std::string& before, const std::string& after) {
  std::string lines;
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) {
    using Row = ShapeRow<Shape>;
    lines.append(before + "\"").append(Row::key).append("\": ").append(Row::example).append(after + "\n");
  });
  return lines;
}

std::string described(const AnyShape& shape, Dimension dimension) { return std::visit(Description{dimension}, shape); }

}  // namespace walkthroughs::model
