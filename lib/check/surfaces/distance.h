/// \file Distances from a point to a face or a patch near a place that corresponds to it, and to all of them.
///
/// Every search ends once it has found a distance that is `enough`, or else with the smallest.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"
#include "check/surfaces/search_starts.h"
#include "check/surfaces/spline.h"

#include <algorithm>
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

/// Looks for the nearest point over the faces of a mesh: from a place on a face and, if that is farther than
/// a limit, from the middles of the faces beside it, where it is if surfaces have slid a little, then from
/// everywhere.
class FaceSearch {
public:
    /// Mesh and neighbourhoods must outlive this.
    FaceSearch(const CheckedMesh& mesh, const Neighbourhoods& around, SearchStarts::LatticeOn latticeOn);

    /// \param within  the face: both parameters from 0 to 1
    /// \param search  from parameters in a face, for a distance
    template <class Search>
    [[nodiscard]] double nearest(const Place& point, int face, const Parameters& within, double limit,
                                 const Search& search) const {
        double nearest = search(face, within);
        for (std::size_t side = 0; side < 4 && nearest > limit; ++side)
            if (const int beside = faceBeside(face, side); beside >= 0)
                nearest = std::min(nearest, search(beside, Parameters{0.5, 0.5}));
        if (nearest <= limit) return nearest;
        return starts_.nearest(point, nearest, limit, [&](const Start& start) {
            return search(static_cast<int>(start.part), start.parameters);
        });
    }

private:
    /// -1 where the mesh ends.
    [[nodiscard]] int faceBeside(int face, std::size_t side) const;

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    SearchStarts starts_;
};

/// From points to a mesh whose quads are bilinear.
class DistanceToMesh {
public:
    /// Both must outlive this.
    DistanceToMesh(const CheckedMesh& mesh, const Neighbourhoods& around);

    /// To a face, and if that is farther than the limit, to whatever may be nearer. Never less than the true
    /// distance.
    /// \param start  parameters in the face
    [[nodiscard]] double from(const Place& point, int face, const Parameters& start, double limit = 0) const;

private:
    const CheckedMesh& mesh_;
    FaceSearch search_;
};

/// Knows which patch lies over every face.
class DistanceToSurfaces {
public:
    /// All but the layout must outlive this.
    DistanceToSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                       const SurfacesPart& part);

    /// From a point to the patch over a face, and if that is farther than the limit, to whatever may be
    /// nearer: surfaces may slide into other patches, a patch may meet itself, and a reference of another
    /// shape draws surfaces away from their faces. Never less than the true distance.
    /// \param within  the face: both parameters from 0 to 1, in the order of its patch
    [[nodiscard]] double from(const Place& point, int face, const Parameters& within, double limit) const;

private:
    struct FacePlace {
        std::size_t patch = 0;
        int column = 0;
        int row = 0;
    };

    [[nodiscard]] Parameters inPatch(std::size_t face, const Parameters& within) const;

    const SurfacesPart& part_;
    std::vector<FacePlace> places_; ///< by face
    FaceSearch search_;
};

} // namespace qm::check
