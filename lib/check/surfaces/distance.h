/// \file Distances from a point to a face or a patch near a place that corresponds to it, and to all of them.
///
/// Every search takes Gauss-Newton steps, and Newton's once one was too long. It ends when it has found a
/// distance that is `enough`, or else with the smallest, which is never less than the true one.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "check/mesh/vectors.h"
#include "check/surfaces/search_starts.h"
#include "check/surfaces/spline.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace qm::check {

/// From a point to a bilinear quad, beginning at `start`.
[[nodiscard]] double distanceToFace(const CheckedMesh& mesh, int face, Parameters start, const Place& point,
                                    double enough = 0);

/// From a point to a patch, beginning at the parameters.
[[nodiscard]] double distanceToPatch(const SurfacesPart::Patch& patch, Parameters parameters,
                                     const Place& point, double enough = 0);

/// Where the search from a point ended: surfaces that have slid have slid as far beside it, so that the
/// search from the next point begins there as well.
struct LastFace {
    int face = -1; ///< -1: none yet
};

/// Looks for a point within a limit, or else for the nearest one, over the faces of a mesh: from the middle
/// of the last face and from a place on a face, then from the middles of the faces beside the nearer of them,
/// and so on, where it is if surfaces have slid; then from everywhere.
class FaceSearch {
public:
    /// Mesh and neighbourhoods must outlive this.
    FaceSearch(const CheckedMesh& mesh, const Neighbourhoods& around, SearchStarts::LatticeOn latticeOn);

    /// \param within  the face: both parameters from 0 to 1
    /// \param search  from parameters in a face, for a distance
    template <class Search>
    [[nodiscard]] double nearest(const Place& point, int face, const Parameters& within, double limit,
                                 LastFace& last, const Search& search) const {
        double nearest = HUGE_VAL;
        const auto isNearer = [&](int other, const Parameters& from) {
            if (other < 0 || nearest <= limit) return false;
            const double there = search(other, from);
            if (!(there < nearest)) return false;
            nearest = there;
            return true;
        };
        const Parameters middle{0.5, 0.5};
        const bool fromLast = last.face != face && isNearer(last.face, middle);
        if (!isNearer(face, within) && fromLast) face = last.face;
        for (int next = face; nearest > limit; face = next) {
            for (std::size_t side = 0; side < 4; ++side)
                if (const int beside = faceBeside(face, side); isNearer(beside, middle)) next = beside;
            if (next == face) break;
        }
        last.face = face;
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
    [[nodiscard]] double from(const Place& point, int face, const Parameters& start, double limit,
                              LastFace& last) const;

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
    [[nodiscard]] double from(const Place& point, int face, const Parameters& within, double limit,
                              LastFace& last) const;

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
