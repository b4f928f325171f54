/// \file Surfaces as a boundary representation: plain lists of vertices, edges and faces that share them.
#pragma once

#include "export/boundary/boundary_parts.h"
#include "export/boundary/shared_edges.h"
#include "export/faces/face_patches.h"
#include "export/geometry/curve_piece.h"
#include "mesh/quad_mesh.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <array>
#include <cstddef>
#include <gp_Pnt.hxx>
#include <vector>

namespace qm {

struct BoundaryVertex {
    gp_Pnt point;
    double tolerance = 0; ///< largest of all edges that end here
};

struct BoundaryEdge {
    CurvePiece curve; ///< from start to end; has the same parameters as the curves of `onFaces`
    std::array<Handle(Geom2d_BSplineCurve), 2> onFaces; ///< forwards and backwards; none on planes
    std::array<std::size_t, 2> ends{};                  ///< numbers of the vertices at its start and its end
    double tolerance = 0;                               ///< largest distance from the faces' surfaces
    bool isOpen = false;                                ///< has a face on one side only
    bool isSmooth = false; ///< the faces' normals differ by less than 0.01 radians
    /// Largest angle between the faces' normals, in degrees, if simple surfaces replace patches that met
    /// smoothly here; 0 elsewhere.
    double newAngle = 0;
};

struct BoundaryFace {
    Handle(Geom_Surface) surface;
    bool reversed = false; ///< the surface's normal points inwards
    bool isSimple = false; ///< a plane, cylinder, cone, sphere or torus
    /// The outline, counter-clockwise, seen from outside; then holes, clockwise.
    std::vector<std::vector<EdgeUse>> loops;
};

struct Boundary {
    std::vector<BoundaryVertex> vertices;
    std::vector<BoundaryEdge> edges;
    std::vector<BoundaryFace> faces; ///< in the order of the patches
    std::vector<BoundaryPart> parts;
    double resolution = 0; ///< the smallest tolerance: closer points are taken for one
    double flatness = 0;   ///< largest distance of a plane face from its patch
    double largestGap = 0; ///< between patches, before simple surfaces replace them
};

/// Calls a function with every face's number and each of its uses of edges.
template <class Function> void forEachUse(const Boundary& boundary, const Function& function) {
    for (std::size_t face = 0; face < boundary.faces.size(); ++face)
        for (const std::vector<EdgeUse>& loop : boundary.faces[face].loops)
            for (const EdgeUse& use : loop)
                function(face, use);
}

/// The tolerance that covers a gap which was sampled.
[[nodiscard]] double toleranceOf(double gap, double resolution);

/// Where an edge is on the face on one of its sides, in the parameter plane of the face.
/// \param parameter  of the edge
[[nodiscard]] gp_Pnt2d parametersAt(const BoundaryFace& face, const BoundaryEdge& edge, std::size_t side,
                                    double parameter);

/// The length of the curve's control polygon: the edge is no longer.
[[nodiscard]] double maxLength(const BoundaryEdge& edge);

/// The largest tolerance of a vertex; no edge has a larger one.
[[nodiscard]] double largestTolerance(const Boundary& boundary);

/// Makes the tolerance of an edge, and of the vertices where it ends, at least so large.
void raiseTolerance(Boundary& boundary, std::size_t edge, double tolerance);

/// Drops edges that no face uses, and vertices without edges.
void dropUnused(Boundary& boundary);

/// By edge: the faces that use it.
[[nodiscard]] std::vector<std::vector<std::size_t>> facesOfEdges(const Boundary& boundary);

/// Takes the topology from the layout: one face per patch, and one edge between any two vertices where
/// borders meet, used by the patches on both sides. So nothing has to be sewn, and a gap between patches
/// becomes the tolerance of the edge that they share. Plane patches become planes.
/// \param faces     none touches itself, see `separated`
/// \param simplify  by face: the largest distance between a patch and the plane, cylinder, cone, sphere or
/// torus that replaces it; empty or 0 allows only exact planes
[[nodiscard]] Boundary makeBoundary(const QuadMesh& mesh, const FacePatches& faces,
                                    const std::vector<double>& simplify = {});

} // namespace qm
