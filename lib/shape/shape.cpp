#include "shape/shape.h"

#include "base/error.h"
#include "mesh/build_mesh.h"
#include "shape/ball.h"
#include "shape/machine_parts.h"
#include "shape/rings.h"
#include "shape/soft_solids.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

struct Recipe {
    ShapeKind kind;
    QuadList (*make)(int resolution, const ShapeOptions& options);
};

constexpr std::array recipes{
    Recipe{{"block", "a block with a filleted through hole, sharp outside", 8},
           [](int n, const ShapeOptions&) { return blockShape(n); }},
    Recipe{{"bracket", "two plates at a right angle with a fillet and holes", 6},
           [](int n, const ShapeOptions&) { return bracketShape(n); }},
    Recipe{{"cube", "a cube", 8}, [](int n, const ShapeOptions&) { return cubeShape(n); }},
    Recipe{{"genus2", "a pretzel with two holes, soft all over", 6},
           [](int n, const ShapeOptions&) { return pretzelShape(n, 2); }},
    Recipe{{"genus3", "a thick plate with three drilled holes", 6},
           [](int n, const ShapeOptions&) { return drilledShape(n, 3); }},
    Recipe{{"helix", "a twisted ring with a boss: separatrices wind around it many times", 4},
           [](int n, const ShapeOptions&) { return helixShape(n); }},
    Recipe{{"plate", "a flat sheet with a round hole: a boundary", 8},
           [](int n, const ShapeOptions&) { return plateShape(n); }},
    Recipe{{"random", "a random solid made of cubes, softened; see --seed", 4},
           [](int n, const ShapeOptions& options) { return randomShape(n, options.voxels, options.seed); }},
    Recipe{
        {"random-open", "the same with pieces of its surface taken out", 4},
        [](int n, const ShapeOptions& options) { return randomOpenShape(n, options.voxels, options.seed); }},
    Recipe{{"sphere", "a cube drawn onto a sphere", 8},
           [](int n, const ShapeOptions&) { return sphereShape(n); }},
    Recipe{{"torus", "a ring: no extraordinary vertex", 6},
           [](int n, const ShapeOptions&) { return torusShape(n); }},
    Recipe{{"tube", "an open tube: an annulus, no extraordinary vertex", 6},
           [](int n, const ShapeOptions&) { return tubeShape(n); }},
};

constexpr auto kinds = [] {
    std::array<ShapeKind, recipes.size()> result{};
    std::ranges::transform(recipes, result.begin(), &Recipe::kind);
    return result;
}();

/// The number of quads is that of the coarsest mesh times the square of the resolution.
void checkSize(const Recipe& recipe, int resolution, const ShapeOptions& options) {
    constexpr double maxQuads = 1e7;
    constexpr int maxVoxels = 100'000;
    if (options.voxels < 1 || options.voxels > maxVoxels)
        throw Error("voxels", "must be from 1 to " + std::to_string(maxVoxels));
    if (resolution < 1) throw Error("resolution", "must be 1 or more");
    const auto coarsest = static_cast<double>(recipe.make(1, options).quads.size());
    if (coarsest * resolution * resolution > maxQuads)
        throw Error("resolution", "the mesh would have more than ten million quads", "Choose a lower one");
}

} // namespace

std::span<const ShapeKind> shapeKinds() {
    return kinds;
}

QuadMesh makeShape(const std::string& name, const ShapeOptions& options) {
    const auto recipe =
        std::ranges::find_if(recipes, [&](const Recipe& other) { return other.kind.name == name; });
    if (recipe == recipes.end())
        throw Error("", "there is no shape \"" + name + '"', "--list shows them all");
    const int resolution = options.resolution == 0 ? recipe->kind.resolution : options.resolution;
    checkSize(*recipe, resolution, options);
    QuadList list = recipe->make(resolution, options);
    return buildMesh(list.points, list.quads);
}

} // namespace qm
