#include "shape/shape.h"

#include "base/error.h"
#include "mesh/soup/build_mesh.h"
#include "shape/sample_meshes.h"
#include "shape/scan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace qm {
namespace {

struct Recipe {
    ShapeKind kind;
    QuadList (*make)(int resolution, const ShapeOptions& options);
    bool round = false; ///< heeds ShapeOptions::around
    int aroundStep = 1; ///< what that must be a multiple of
};

int around(int resolution, const ShapeOptions& options) {
    return options.around > 0 ? options.around : 4 * resolution;
}

constexpr std::array recipes{
    Recipe{{"block", "a block with a filleted through hole, sharp outside", 8},
           [](int n, const ShapeOptions&) { return blockShape(n); }},
    Recipe{{"bracket", "two plates at a right angle with a fillet and holes", 6},
           [](int n, const ShapeOptions&) { return bracketShape(n); }},
    Recipe{{"cube", "a cube", 8}, [](int n, const ShapeOptions&) { return cubeShape(n); }},
    Recipe{{"cylinder", "a cylinder with both its caps, sharp at their rims", 8},
           [](int n, const ShapeOptions& options) { return cylinderShape(around(n, options)); },
           true,
           2},
    Recipe{{"genus2", "a pretzel with two holes, soft all over", 6},
           [](int n, const ShapeOptions&) { return pretzelShape(n, 2); }},
    Recipe{{"genus3", "a thick plate with three drilled holes", 6},
           [](int n, const ShapeOptions&) { return drilledShape(n, 3); }},
    Recipe{{"helix", "a twisted ring with a boss: separatrices wind around it many times", 4},
           [](int n, const ShapeOptions&) { return helixShape(n); }},
    Recipe{{"plate", "a flat sheet with a round hole: a boundary", 8},
           [](int n, const ShapeOptions&) { return plateShape(n); }},
    Recipe{{"random", "a random solid made of cubes, softened; see --seed", 4, true},
           [](int n, const ShapeOptions& options) { return randomShape(n, options.voxels, options.seed); }},
    Recipe{
        {"random-open", "the same with pieces of its surface taken out", 4, true},
        [](int n, const ShapeOptions& options) { return randomOpenShape(n, options.voxels, options.seed); }},
    Recipe{{"sphere", "a cube drawn onto a sphere", 8},
           [](int n, const ShapeOptions& options) { return sphereShape(around(n, options)); },
           true,
           2},
    Recipe{{"torus", "a ring: no extraordinary vertex", 6},
           [](int n, const ShapeOptions& options) { return torusShape(around(n, options)); },
           true},
    Recipe{{"tube", "an open tube: an annulus, no extraordinary vertex", 6},
           [](int n, const ShapeOptions& options) { return tubeShape(around(n, options)); },
           true},
};

constexpr auto kinds = [] {
    std::array<ShapeKind, recipes.size()> result{};
    std::ranges::transform(recipes, result.begin(), &Recipe::kind);
    return result;
}();

const Recipe& recipeNamed(const std::string& name) {
    const auto recipe =
        std::ranges::find_if(recipes, [&](const Recipe& other) { return other.kind.name == name; });
    if (recipe == recipes.end())
        throw Error("", "there is no shape \"" + name + '"', "--list shows them all");
    return *recipe;
}

/// The number of quads of the coarsest mesh; that of others is larger by the square of the resolution.
double coarsestQuads(const Recipe& recipe, ShapeOptions options) {
    if (options.voxels < 1 || options.voxels > ShapeLimits::maxVoxels)
        throw Error("voxels", "must be from 1 to " + std::to_string(ShapeLimits::maxVoxels));
    options.around = 0;
    return static_cast<double>(recipe.make(1, options).quads.size());
}

void checkAround(const Recipe& recipe, int around) {
    constexpr int min = 4;
    const std::string name = recipe.kind.name;
    if (!recipe.round) throw Error("around", name + " has no such number", "Give a resolution");
    if (around < min || around % recipe.aroundStep != 0)
        throw Error("around", std::string("must be ") + (recipe.aroundStep == 2 ? "even and " : "") +
                                  "at least " + std::to_string(min));
}

QuadList makeQuads(const Recipe& recipe, const ShapeOptions& options) {
    if (options.around != 0) checkAround(recipe, options.around);
    const int resolution = options.resolution == 0 ? recipe.kind.resolution : options.resolution;
    if (resolution < 1) throw Error("resolution", "must be 1 or more");
    const double fineness = options.around > 0 ? options.around / 4.0 : resolution;
    if (coarsestQuads(recipe, options) * fineness * fineness > ShapeLimits::maxQuads)
        throw Error(options.around > 0 ? "around" : "resolution",
                    "the mesh would have more than ten million quads", "Choose a lower one");
    return recipe.make(resolution, options);
}

} // namespace

std::span<const ShapeKind> shapeKinds() {
    return kinds;
}

QuadMesh makeShape(const std::string& name, const ShapeOptions& options) {
    const QuadList list = makeQuads(recipeNamed(name), options);
    return buildMesh(list.points, list.quads);
}

Triangles makeScan(const std::string& name, double triangles, ShapeOptions options) {
    const Recipe& recipe = recipeNamed(name);
    if (!(triangles >= 1) || triangles > ShapeLimits::maxTriangles)
        throw Error("scan", "the number of triangles must be from 1 to twenty million");
    options.around = 0;
    const double coarsest = coarsestQuads(recipe, options);
    const auto make = [&](double resolution) {
        const double finest = std::floor(std::sqrt(ShapeLimits::maxQuads / coarsest));
        options.resolution = static_cast<int>(std::clamp(std::round(resolution), 1.0, finest));
        return makeQuads(recipe, options);
    };
    const double quads = triangles / 2;
    QuadList list = make(std::sqrt(quads / coarsest));
    // Where the number does not quite grow with the square, a second step comes nearer.
    const double share = static_cast<double>(list.quads.size()) / quads;
    if (std::abs(share - 1) > 0.1 && options.resolution > 1)
        list = make(options.resolution / std::sqrt(share));
    return trianglesOf(list);
}

} // namespace qm
