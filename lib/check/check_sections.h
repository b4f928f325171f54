/// \file Is a section of a document true? One function for each, or for a part of it, in a source of its own
/// name.
///
/// Every one reports what is wrong, and takes sections before its own for true.
#pragma once

#include "check/document/checked_document.h"
#include "check/document/report.h"
#include "check/mesh/angles.h"
#include "check/mesh/neighbourhoods.h"
#include "check/tracks/lines.h"

#include <span>
#include <string>
#include <vector>

namespace qm::check {

/// What the checks of tracks have in common.
struct Context {
    const CheckedMesh& mesh;
    const Neighbourhoods& around;
    Angles angles;
    EdgeCosts costs;
    ConstraintsPart constraints; ///< with sound paths
    double segmentCost = 0;      ///< of every segment
    std::vector<int> labels;     ///< sub-mesh of every vertex; empty if the mesh is not cut
};

/// The base complex of the mesh (docs/METHOD.md#base-complex).
/// \param network  the lines of the whole mesh, without feature seeds
void checkBaseComplex(const Neighbourhoods& around, const LineNetwork& network, const BaseComplexPart& part,
                      Report& report);

/// Feature curves and seeds (docs/METHOD.md#features). Curves may have been added by hand, so only what later
/// stages rest on is asked for: each runs along one mesh line, and its seed is a regular interior vertex of
/// it and no other curve's seed.
/// \return  for every sound seed a step from it along its curve
[[nodiscard]] std::vector<int> checkFeatures(const Neighbourhoods& around, const FeaturesPart& part,
                                             Report& report);

/// A division of the mesh (docs/METHOD.md#mesh-cut): every vertex belongs to one sub-mesh, and every sub-mesh
/// has vertices.
/// \return  whether `part.labels` can be used
[[nodiscard]] bool checkLabels(const Neighbourhoods& around, const CutPart& part, Report& report);

/// U, n_j and the terminals of every sub-mesh.
/// \param networks  the lines of every sub-mesh
void checkSubMeshes(const Neighbourhoods& around, const std::vector<LineNetwork>& networks,
                    const CutPart& part, Report& report);

/// Reports constraints that are no paths along edges.
/// \return  whether all are paths
[[nodiscard]] bool checkConstraintPaths(const Neighbourhoods& around, const ConstraintsPart& constraints,
                                        Report& report);

/// What a graph belongs to: in one of the whole mesh everything must be that is required.
enum class GraphOf { mesh, subMesh };

/// Reports constraints that a graph does not keep.
/// \param present  by edge: whether it belongs to the graph
/// \param pointer  of the graph's tracks
void checkConstraints(const Context& context, std::span<const char> present, GraphOf what,
                      const std::string& pointer, Report& report);

/// Motorcycle graphs of the sub-meshes (docs/METHOD.md#sub-meshes), rightly priced, sorted, and all
/// different.
/// \param networks  the lines of every sub-mesh, with the feature seeds
/// \param complex   what tracks refer to by separatrix; may be null
void checkEnumeration(const Context& context, const std::vector<LineNetwork>& networks,
                      const BaseComplexPart* complex, const EnumerationPart& part, Report& report);

/// A layout: its tracks, their cost, its segments (docs/METHOD.md#layout). Straight from the merge the tracks
/// must be a motorcycle graph, by both sets of rules. The tracks of a pruned layout run straight, from and to
/// wherever the segments allow. In a component without sources the tracks make up one whole mesh line.
/// Transversals run straight from one track or boundary to another and cost nothing.
/// \param network  the lines of the whole mesh, with the feature seeds
void checkLayout(const Context& context, const LineNetwork& network, const LayoutPart& part, Report& report);

/// A layout's figures of quality, all that are given.
/// \param part     with sound segments
/// \param onTrack  by edge
void checkQuality(const Neighbourhoods& around, const Angles& angles, std::span<const char> onTrack,
                  const LayoutPart& part, Report& report);

/// A front: no layout of it is as good as another in everything, none is below its bound, and what is said to
/// be proven attains it.
void checkFront(const LayoutPart& part, Report& report);

/// B-spline surfaces, and what their fit has promised (docs/METHOD.md#smooth-fit). One patch for each
/// segment, in their order, with sound knots whose domain is the segment's grid, and finite control points.
/// An interpolating fit passes through every vertex within 1e-9 of the bounding box's diagonal, and the
/// rounding of its coordinates. Neighbours of a smooth fit agree along their borders within the same.
/// \param layout  must have passed its own check
void checkSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                   const SurfacesPart& part, Report& report);

/// How good the surfaces are. Measures every patch on a lattice of 16 samples an edge, and every border at 16
/// samples an edge: distances from the mesh's quads and vertices, gaps, angles between normals across smooth
/// borders and across lines within patches, folds. A figure that is less than what is found is a violation;
/// what is not stated is not checked. Linear in the mesh; only points that lie farther from the surfaces
/// nearby than is stated are compared with all of them, until the first violation of a patch.
/// \param layout  must have passed its own check
/// \param part    with sound knots and control points
void checkFigures(const Context& context, const LayoutPart& layout, const SurfacesPart& part, unsigned jobs,
                  Report& report);

/// The part of `checkFigures` about meetings of patches, gaps and angles between normals: at 16 samples of
/// every edge at which two patches meet, the first and the last at 1/200 of the edge from its ends; and along
/// every line within a patch at which a knot is repeated as often as the degree says.
void checkMeetings(const Context& context, const LayoutPart& layout, const SurfacesPart& part,
                   Report& report);

/// The part of `checkFigures` about figures among themselves: means are not above maxima, relative lengths
/// fit the diagonal, and the figures of all patches are those of each. The distance from the reference cannot
/// be measured, as the reference is not part of the document; but it passes through the vertices, unless it
/// is a scan or has bridged quads with flat corners.
void checkAgreement(const CheckedMesh& mesh, const SurfacesPart& part, Report& report);

/// What a figure of a patch must not be less than.
struct FoundFigure {
    const char* figure; ///< its key
    double value = 0;
    double slack = 0;  ///< for rounding
    std::string where; ///< ends a sentence: "at face 3"
};

/// Reports a figure that is less than what is found.
/// \return whether it is less
bool checkFigure(const SurfacesPart& part, std::size_t patch, const FoundFigure& found, Report& report);

} // namespace qm::check
