/// \file Documents that are true of a small mesh by construction, which tests of the checker then falsify.
#pragma once

#include "check/document/checked_document.h"
#include "check/mesh/neighbourhoods.h"

#include <vector>

namespace qm::test {

struct DocumentRecipe {
    std::vector<std::vector<int>> curves; ///< feature curves; each has its seed at the second vertex
    std::vector<int> labels;              ///< sub-mesh of every vertex; empty for no cut
    int subMeshes = 1;
};

/// A document with base complex, features, cut, all graphs by brute force, the layout of the cheapest graph
/// (of the whole mesh, even if it is cut), and bilinear patches. Only for meshes on which every component has
/// a source and no graph leaves an annulus.
[[nodiscard]] check::CheckedDocument trueDocument(const check::CheckedMesh& mesh,
                                                  const DocumentRecipe& recipe = {});

/// The segments into which a set of edges cuts the mesh, each starting at a convex corner.
/// \param border  for every edge, whether it is in the set; the mesh boundary need not be
[[nodiscard]] std::vector<check::LayoutPart::Segment> segmentsBetween(const check::CheckedMesh& mesh,
                                                                      const check::Neighbourhoods& around,
                                                                      const std::vector<char>& border);

/// Patches of degree 1 through the vertices of the segments.
[[nodiscard]] check::SurfacesPart bilinearPatches(const check::CheckedMesh& mesh,
                                                  const check::LayoutPart& layout);

} // namespace qm::test
