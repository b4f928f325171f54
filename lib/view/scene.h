/// \file What a page shows: points, and layers of faces, lines and points over them, as plain arrays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace qm {

/// Where the points of a layer lie.
enum class Base {
    mesh,     ///< the mesh's vertices, by their index
    surfaces, ///< a lattice on every fitted surface
    net,      ///< control points
    knots     ///< the lines on the surfaces at which a knot lies
};

/// The mesh: its points and quads.
struct Shell {
    std::vector<float> positions;     ///< x, y, z of every point, about the scene's centre
    std::vector<std::uint32_t> quads; ///< four points each, in the order of the faces
};

/// The fitted surfaces. The page evaluates them: all bases but `Base::mesh` come from them. The points of
/// `Base::surfaces` are those at all multiples of 1 / steps, patch by patch and row by row along u.
struct FittedPatches {
    std::vector<std::array<int, 2>> degrees;
    std::vector<std::array<int, 2>> counts; ///< control points along u and v
    std::vector<std::array<std::vector<double>, 2>> knots;
    std::vector<float> controlPoints; ///< x, y, z of those of all patches, about the scene's centre
    std::vector<std::uint32_t> faces; ///< mesh faces below all patches, row by row
    std::size_t steps = 1;            ///< of the lattice, for every mesh edge
};

/// A figure of every item of a layer; NaN where there is nothing to say.
struct Column {
    std::string name; ///< as users read it, with its unit
    std::vector<float> values;
    bool rough = false; ///< none is negative, and four digits of the largest will do
};

/// What can be pointed at, numbered from 0 as in the document.
struct Items {
    std::string noun; ///< "separatrix"
    /// JSON pointer of item 0, 1, ... without its number: "/baseComplex/separatrices/". Where items are not
    /// numbered like that, figures stand in braces: "/layout/segments/{of segment}/sides/{side}". May be
    /// empty.
    std::string pointer;
    std::size_t count = 0;
    std::vector<Column> columns;
};

/// How a layer's figures become colours.
enum class Scale {
    none,
    rising,  ///< from 0 to where all but a few figures lie below
    centred, ///< the same on both sides of 0
    verdict  ///< within half of the limit, within the limit, or beyond it
};

/// Figures that are shown as colours.
struct Mapped {
    Scale scale = Scale::none;
    /// A figure at every point; if empty, what `source` names.
    std::vector<float> values;
    /// Names a layer that has the same values, a column of the items, or "mean curvature" or "Gauss
    /// curvature" of the surfaces.
    std::string source;
    std::string quantity;             ///< "distance from the reference"
    std::string unit;                 ///< "mm"
    std::optional<double> limit = {}; ///< beyond which a figure is not what it should be
};

enum class Paint {
    plain,  ///< one colour
    items,  ///< the colours of items
    mapped, ///< by figures
    stripes ///< reflections of stripes, smooth where the surface is
};

/// What all layers have.
struct Layer {
    std::string name;  ///< as --show knows it
    std::string title; ///< as people read it
    Base base = Base::mesh;
    Items items;
};

struct FaceLayer : Layer {
    Paint paint = Paint::plain;
    std::vector<std::uint32_t> groups;  ///< item of every face of the mesh, or `noItem`; not for patches
    std::vector<std::uint32_t> colours; ///< of every item, a number below `colourCount`
    Mapped mapped;
    std::string itemsOf; ///< the name of a layer that has the same items; else empty
};

struct LineLayer : Layer {
    /// Where every item begins in `points`, and the end of the last; nets and knots need neither.
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> points; ///< along each item
    Mapped mapped;
};

struct PointLayer : Layer {
    std::vector<std::uint32_t> points; ///< one for every item
};

constexpr std::uint32_t noItem = 0xffffffff;

struct Scene {
    std::string title;
    std::string kind;                                    ///< of the document
    std::vector<std::pair<std::string, double>> figures; ///< of the whole document
    double radius = 1;                                   ///< of a ball about the centre with everything in it
    Shell mesh;
    FittedPatches patches;
    std::vector<std::int32_t> subMeshOfVertex; ///< empty if there is no cut
    std::vector<FaceLayer> faces;              ///< one of them is seen at a time
    std::vector<LineLayer> lines;
    std::vector<PointLayer> points;
    std::vector<std::string> shown; ///< names of the layers that are on at first
};

} // namespace qm
