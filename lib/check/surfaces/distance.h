/// \file Distances from a point to a face or a patch near a place that corresponds to it, and to all of them.
///
/// Every search ends once it has found a distance that is `enough`, or else with the smallest.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"
#include "check/surfaces/search_starts.h"
#include "check/surfaces/spline.h"

#include <cstddef>
#include <vector>

namespace qm::check {

/// From a point to a bilinear quad, by the Gauss-Newton iteration from `start`. Never less than the true
/// distance.
[[nodiscard]] double distanceToFace(const CheckedMesh& mesh, int face, Parameters start, const Place& point,
                                    double enough = 0);

/// From a point to a patch, by the Gauss-Newton iteration from the parameters. Never less than the true
/// distance.
[[nodiscard]] double distanceToPatch(const SurfacesPart::Patch& patch, Parameters parameters,
                                     const Place& point, double enough = 0);

/// From points to a mesh whose quads are bilinear.
class DistanceToMesh {
public:
    /// Both must outlive this.
    DistanceToMesh(const CheckedMesh& mesh, const Neighbourhoods& around);

    /// To a face, and if that is farther than the limit, to those beside it, then to whatever may be nearer.
    /// Never less than the true distance.
    /// \param start  parameters in the face
    [[nodiscard]] double from(const Place& point, int face, const Parameters& start, double limit = 0) const;

private:
    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    SearchStarts starts_; ///< on faces
};

/// Knows which patch lies over every face.
class DistanceToSurfaces {
public:
    /// All but the layout must outlive this.
    DistanceToSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                       const SurfacesPart& part);

    /// From a point to the patch over a face, and if that is farther than the limit, to what lies over the
    /// faces beside it, then to whatever may be nearer: surfaces may slide into other patches, a patch may
    /// meet itself, and a reference of another shape draws surfaces away from their faces. Never less than
    /// the true distance.
    /// \param within  the face: both parameters from 0 to 1, in the order of its patch
    [[nodiscard]] double from(const Place& point, int face, const Parameters& within, double limit) const;

private:
    struct FacePlace {
        std::size_t patch = 0;
        int column = 0;
        int row = 0;
    };

    [[nodiscard]] double overFace(const Place& point, std::size_t face, const Parameters& within,
                                  double limit) const;
    [[nodiscard]] Parameters inPatch(std::size_t face, const Parameters& within) const;

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const SurfacesPart& part_;
    std::vector<FacePlace> places_; ///< by face
    SearchStarts starts_;           ///< over faces
};

} // namespace qm::check
