/// \file The layers of a scene, one function for each section of a document.
#pragma once

#include "view/build_scene.h"
#include "view/scene.h"

namespace qm {

/// The mesh's points, quads and edges.
/// \param centre  becomes the origin
void addMesh(Scene& scene, const Viewed& viewed, const Point& centre);
void addBaseComplex(Scene& scene, const Viewed& viewed);
void addFeatures(Scene& scene, const Viewed& viewed);
void addCut(Scene& scene, const QuadMesh& mesh, const Cut& cut);
/// The best graph of every sub-mesh.
void addGraphs(Scene& scene, const QuadMesh& mesh, const Enumeration& enumeration);
void addLayout(Scene& scene, const QuadMesh& mesh, const Layout& layout);
/// Samples of the patches with their distance to the mesh, the patches' borders, and their control points.
void addSurfaces(Scene& scene, const Viewed& viewed, const Point& centre, unsigned jobs);

/// A point's coordinates about a centre, at the end of a list.
void appendPosition(std::vector<float>& positions, const Point& point, const Point& centre);

} // namespace qm
