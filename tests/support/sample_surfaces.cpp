#include "support/true_surface.h"

#include <map>
#include <numbers>

namespace qm::test {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The six faces of the box from the origin to the given corner, without holes.
std::vector<FlatFace> boxFaces(const Point& corner) {
    std::vector<FlatFace> faces;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            FlatFace face{.axis = axis, .level = far ? corner[axis] : 0, .outward = far ? 1.0 : -1.0};
            face.high = {corner[(axis + 1) % 3], corner[(axis + 2) % 3]};
            faces.push_back(face);
        }
    return faces;
}

/// Adds vertical holes to the faces at the top and at the bottom, and their walls.
std::vector<std::variant<Revolved, FlatFace>> withHoles(const std::vector<FlatFace>& faces,
                                                        const std::vector<std::array<double, 2>>& centres,
                                                        double radius, const std::vector<Revolved>& walls) {
    std::vector<std::variant<Revolved, FlatFace>> pieces(walls.begin(), walls.end());
    for (FlatFace face : faces) {
        if (face.axis == 2) {
            face.holes = centres;
            face.radius = radius;
        }
        pieces.emplace_back(face);
    }
    return pieces;
}

TrueSurface block() {
    constexpr double height = 2, hole = 0.6, fillet = 0.35, rim = hole + fillet;
    constexpr std::array<double, 2> middle{1.5, 1.5};
    return TrueSurface(withHoles(
        boxFaces({3, 3, height}), {middle}, rim,
        {Revolved{.axis = middle, .from = {hole, height - fillet}, .to = {hole, fillet}},
         Revolved{.axis = middle,
                  .from = {rim, height - fillet},
                  .radius = fillet,
                  .angles = {turn / 4, turn / 2}},
         Revolved{
             .axis = middle, .from = {rim, fillet}, .radius = fillet, .angles = {turn / 2, 3 * turn / 4}}}));
}

TrueSurface cube() {
    return TrueSurface(withHoles(boxFaces({1, 1, 1}), {}, 0, {}));
}

TrueSurface cylinder() {
    constexpr double height = 3;
    return TrueSurface({Revolved{.from = {0, 0}, .to = {1, 0}}, Revolved{.from = {1, 0}, .to = {1, height}},
                        Revolved{.from = {1, height}, .to = {0, height}}});
}

TrueSurface genus3() {
    constexpr int holes = 3;
    constexpr double radius = 0.75;
    std::vector<std::array<double, 2>> centres;
    std::vector<Revolved> walls;
    for (int k = 0; k < holes; ++k) {
        centres.push_back({3 * k + 1.5, 1.5});
        walls.push_back({.axis = centres.back(), .from = {radius, 1}, .to = {radius, 0}});
    }
    return TrueSurface(withHoles(boxFaces({3.0 * holes, 3, 1}), centres, radius, walls));
}

TrueSurface plate() {
    return TrueSurface({FlatFace{.high = {5, 3}, .holes = {{2.5, 1.5}}, .radius = 0.3}});
}

TrueSurface sphere() {
    return TrueSurface({Revolved{.radius = 1, .angles = {-turn / 4, turn / 4}}});
}

TrueSurface torus() {
    return TrueSurface({Revolved{.from = {3, 0}, .radius = 1, .angles = {0, turn}}});
}

TrueSurface tube() {
    return TrueSurface({Revolved{.from = {1, 0}, .to = {1, 6}}});
}

} // namespace

std::optional<TrueSurface> trueSurface(const std::string& part) {
    static const std::map<std::string, TrueSurface (*)()> known{
        {"block", block}, {"cube", cube},     {"cylinder", cylinder}, {"genus3", genus3},
        {"plate", plate}, {"sphere", sphere}, {"torus", torus},       {"tube", tube}};
    const auto found = known.find(part);
    return found == known.end() ? std::nullopt : std::optional(found->second());
}

} // namespace qm::test
