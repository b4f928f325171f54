/// \file What a page shows: points, and layers of faces, lines and points over them, as plain arrays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace qm {

/// Where the points of a layer lie.
enum class Base {
    mesh,     ///< the mesh's vertices, by their index
    surfaces, ///< samples of the fitted surfaces
    net       ///< control points
};
constexpr std::size_t baseCount = 3;

/// The points of a base, and the quads between them.
struct Shell {
    std::vector<float> positions;     ///< x, y, z of every point, about the scene's centre
    std::vector<float> normals;       ///< unit vectors at the points; empty: every quad is flat
    std::vector<std::uint32_t> quads; ///< four points each
    std::vector<std::uint32_t> faces; ///< of the mesh, one for every quad
};

/// A figure of every item of a layer; NaN where there is nothing to say.
struct Column {
    std::string name; ///< as users read it, with its unit
    std::vector<float> values;
};

/// What can be pointed at, numbered from 0 as in the document.
struct Items {
    std::string noun; ///< "separatrix"
    /// JSON pointer of item 0, 1, ... without its number: "/baseComplex/separatrices/"; may be empty.
    std::string pointer;
    std::vector<std::string> pointers; ///< those of all items, where they are not that regular; may be empty
    std::size_t count = 0;
    std::vector<Column> columns;
};

struct FaceLayer {
    std::string name;  ///< as --show knows it
    std::string title; ///< as people read it
    Base base = Base::mesh;
    std::vector<std::uint32_t> groups;  ///< item of every quad, or `noItem`; empty: the quads are all alike
    std::vector<std::uint32_t> colours; ///< of every item, a number below `colourCount`
    std::vector<float> values;          ///< a figure at every point, shown as a colour map; may be empty
    double scale = 0;                   ///< the end of the colour map, which begins at 0
    std::string unit;                   ///< of the figure, for the scale
    Items items;
};

struct LineLayer {
    std::string name;
    std::string title;
    Base base = Base::mesh;
    std::vector<std::uint32_t> starts; ///< where every item begins in `points`, and the end of the last
    std::vector<std::uint32_t> points; ///< along each item
    Items items;
};

struct PointLayer {
    std::string name;
    std::string title;
    Base base = Base::mesh;
    std::vector<std::uint32_t> points; ///< one for every item
    Items items;
};

constexpr std::uint32_t noItem = 0xffffffff;

struct Scene {
    std::string title;
    std::string kind;                                    ///< of the document
    std::vector<std::pair<std::string, double>> figures; ///< of the whole document
    double radius = 1;                                   ///< of a ball about the centre with everything in it
    std::array<Shell, baseCount> shells;
    std::vector<std::int32_t> subMeshOfVertex; ///< empty if there is no cut
    std::vector<FaceLayer> faces;              ///< one of them is seen at a time
    std::vector<LineLayer> lines;
    std::vector<PointLayer> points;
    std::vector<std::string> shown; ///< names of the layers that are on at first
};

} // namespace qm
