/// \file Faces that are planes, cylinders, cones, spheres or tori, and the edges where two of them meet.
#pragma once

#include "export/boundary/shared_edges.h"
#include "export/faces/face_patches.h"
#include "export/geometry/curve_piece.h"
#include "export/simple/simple_surface.h"

#include <Geom_BSplineCurve.hxx>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Programs take two faces for one smooth surface below this angle between normals, in degrees: 0.01 radians.
constexpr double smoothAngle = 0.57;
/// How far from the ends of an edge, in mesh edges, normals are compared: patches may have none there.
constexpr double fromEdgeEnds = 0.005;

struct SimpleFaceTolerances {
    double flatness = 0;   ///< largest distance of a plane patch's control points from its plane
    double resolution = 0; ///< closer points are taken for one
    /// By face: the largest distance between a patch and the plane, cylinder, cone, sphere or torus that
    /// replaces it; empty or 0 allows only planes within the flatness.
    std::vector<double> simplify;
};

/// By patch: the simple surface that replaces it, if there is one.
class SimpleFaces {
public:
    /// \param shared  the edges of the faces
    SimpleFaces(const FacePatches& faces, const SharedEdges& shared, const SimpleFaceTolerances& tolerances);

    [[nodiscard]] const std::optional<SimpleSurface>& operator[](std::size_t face) const {
        return surfaces_[face];
    }

    /// Whether surfaces replace patches that are not exactly those.
    [[nodiscard]] bool isAnalytic() const { return tolerance_ > 0; }

    /// Moves vertices where several simple faces meet onto all of these, unless that is far away (or, where
    /// other faces meet as well, not very near), and then to where edges between two faces of one cylinder or
    /// cone can be straight. Does nothing if all simple faces are planes within the flatness.
    /// \param shared  the edges of the patches; its `vertexPoint` changes
    void moveVertices(SharedEdges& shared);

    /// The curve where the two faces of an edge meet, if both are simple and `moveVertices` has moved its
    /// ends onto both: a line, circle or ellipse, or else a spline.
    /// \param border  of the patches
    /// \return nothing if there is none, or if it is far from the border
    [[nodiscard]] std::optional<CurvePiece> exactCurve(const SharedEdge& edge, const SharedEdges& shared,
                                                       const Handle(Geom_BSplineCurve) & border) const;

    /// The border where an edge has no exact curve. If `moveVertices` has moved its ends, and a face of it is
    /// simple, it ends where they are now: an outline on a simple face must not be open.
    [[nodiscard]] Handle(Geom_BSplineCurve) movedBorder(const SharedEdge& edge, const SharedEdges& shared,
                                                        const Handle(Geom_BSplineCurve) & border) const;

private:
    /// \param facesAt  by vertex: the simple faces there
    void straightenSeams(SharedEdges& shared, const std::vector<std::vector<std::size_t>>& facesAt);

    /// The largest distance by which a vertex or an edge may move.
    [[nodiscard]] double reach() const;

    std::vector<std::optional<SimpleSurface>> surfaces_;
    double resolution_;
    double tolerance_ = 0;       ///< the largest between a patch and what replaces it
    std::vector<bool> isCommon_; ///< by vertex: whether it lies on all simple faces there
};

} // namespace qm
