/// \file Surfaces as a boundary representation: vertices, edges and faces that share them, as plain lists.
#pragma once

#include "export/boundary_parts.h"
#include "export/face_patches.h"
#include "export/shared_edges.h"
#include "mesh/quad_mesh.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Surface.hxx>
#include <array>
#include <cstddef>
#include <gp_Pnt.hxx>
#include <vector>

namespace qm {

struct BoundaryVertex {
    gp_Pnt point;
    double tolerance = 0; ///< of all that ends here
};

struct BoundaryEdge {
    Handle(Geom_BSplineCurve) curve; ///< from start to end; over the same parameters as those of `onFaces`
    std::array<Handle(Geom2d_BSplineCurve), 2> onFaces; ///< forwards and backwards; none on planes
    std::array<std::size_t, 2> ends{};                  ///< numbers of the vertices where it starts and ends
    double tolerance = 0;                               ///< largest distance from the faces' surfaces
    bool isOpen = false;                                ///< with a face on one side only
    bool isSmooth = false; ///< the faces' normals differ by less than 0.01 radians
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
    std::size_t lostEdges = 0; ///< that are shorter than `resolution`
    double resolution = 0;     ///< the smallest tolerance: what is taken for one point
    double flatness = 0;       ///< how far a plane face may be from its patch
    double largestGap = 0;     ///< between patches, before simple surfaces take their place
};

/// Of all vertices; no edge has a larger one.
[[nodiscard]] double largestTolerance(const Boundary& boundary);

/// The topology is the layout's: one face for every patch, an edge between any two vertices where borders
/// meet, used by the patches on both sides. So nothing has to be sewn, and a gap between patches becomes the
/// tolerance of the edge that they share. Patches that are plane become planes.
/// \param faces  none touches itself, see separate.h
/// \param simplify  of every face, the largest distance between a patch and the cylinder, cone, sphere, torus
/// or plane that takes its place; none, or 0, for nothing but exact planes
[[nodiscard]] Boundary makeBoundary(const QuadMesh& mesh, const FacePatches& faces,
                                    const std::vector<double>& simplify = {});

} // namespace qm
