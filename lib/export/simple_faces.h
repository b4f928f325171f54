/// \file Faces that need no control points, and the edges where two of them meet.
#pragma once

#include "export/shared_edges.h"
#include "export/simple_surface.h"

#include <Geom_BSplineCurve.hxx>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

struct SimpleFaceTolerances {
    double flatness = 0;   ///< how far the control points of a plane patch may be from its plane
    double resolution = 0; ///< what is taken for one point
    /// Of every face, the largest distance between a patch and the cylinder, cone, sphere, torus or plane
    /// that takes its place; empty, or 0, for nothing but planes within the flatness.
    std::vector<double> simplify;
    double smoothAngle = 0; ///< degrees between normals, below which two faces are one smooth surface
};

/// Of every patch the simple surface in its place, if there is one.
class SimpleFaces {
public:
    /// \param shared  the edges of the patches
    SimpleFaces(const std::vector<Patch>& clampedPatches, const SharedEdges& shared,
                const SimpleFaceTolerances& tolerances);

    [[nodiscard]] const std::optional<SimpleSurface>& operator[](std::size_t face) const {
        return surfaces_[face];
    }

    /// Moves vertices where several simple faces meet onto all of these, unless that is far away. Does
    /// nothing if all simple faces are planes within the flatness.
    /// \param shared  the edges of the patches; its `vertexPoint` changes
    void moveVertices(SharedEdges& shared);

    /// Where the two faces of an edge meet, if both are simple and `moveVertices` has put its ends on both.
    /// \param border  of the patches; over the same parameters as the result
    /// \return null if that is not so, or far from the border
    [[nodiscard]] Handle(Geom_BSplineCurve) exactCurve(const SharedEdge& edge, const SharedEdges& shared,
                                                       const Handle(Geom_BSplineCurve) & border) const;

private:
    std::vector<std::optional<SimpleSurface>> surfaces_;
    double resolution_;
    double reach_ = 0;           ///< how far a vertex or edge may move
    std::vector<bool> isCommon_; ///< by vertex: it lies on all simple faces there
};

} // namespace qm
