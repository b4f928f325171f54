/// \file The layers of a scene: one function for each section of a document, and how they fill layers item by
/// item.
#pragma once

#include "view/build_scene.h"
#include "view/scene.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace qm {

struct BorderMarks;

/// The mesh's points, quads and edges.
/// \param centre  becomes the origin
void addMesh(Scene& scene, const Viewed& viewed, const Point& centre);
void addBaseComplex(Scene& scene, const Viewed& viewed);
void addFeatures(Scene& scene, const Viewed& viewed);
void addCut(Scene& scene, const QuadMesh& mesh, const Cut& cut);
/// The best graph of every sub-mesh.
void addGraphs(Scene& scene, const QuadMesh& mesh, const Enumeration& enumeration);
void addLayout(Scene& scene, const QuadMesh& mesh, const Layout& layout);
/// The patches, how far they are from what they were fitted to, and how they bend; then their lines.
void addSurfaces(Scene& scene, const Viewed& viewed, const Point& centre, unsigned jobs);
/// The borders of the patches, how smoothly they meet, nets and knots. The scene must have the patches.
void addSurfaceLines(Scene& scene, const Viewed& viewed, const BorderMarks& marks);

/// A point's coordinates about a centre, at the end of a list.
void appendPosition(std::vector<float>& positions, const Point& point, const Point& centre);

/// Stands where an item has no such figure.
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Adds a figure of the next item to the column of that name, which is made when it is first used.
void addFigure(Items& items, const std::string& name, double value);
template <class Number> void addFigure(Items& items, const std::string& name, Number value) {
    addFigure(items, name, static_cast<double>(value));
}

/// A layer without items.
template <class Layer>
[[nodiscard]] Layer newLayer(const std::string& name, const std::string& title, const std::string& noun = {},
                             const std::string& pointer = {}) {
    Layer layer;
    layer.name = name;
    layer.title = title;
    layer.items.noun = noun;
    layer.items.pointer = pointer;
    return layer;
}

/// The same for lines, with the place where the first item begins.
[[nodiscard]] LineLayer newLines(const std::string& name, const std::string& title, const std::string& noun,
                                 const std::string& pointer);

/// Ends the item whose points were added.
void endItem(LineLayer& layer);
/// Adds a whole item.
void addItem(LineLayer& layer, std::span<const VertexId> vertices);
/// Adds a whole item, and between which vertices it runs.
void addPath(LineLayer& layer, const std::vector<VertexId>& vertices);
void addPoint(PointLayer& layer, VertexId vertex);

} // namespace qm
