/// \file How far a point of a mesh is from the surfaces that were fitted to it.
#pragma once

#include "check/mesh/context.h"
#include "check/surfaces/distance.h"

#include <cstddef>
#include <vector>

namespace qm::check {

/// Knows which patch lies over every face.
class DistanceToSurfaces {
public:
    /// All arguments outlive this.
    DistanceToSurfaces(const Context& context, const LayoutPart& layout, const SurfacesPart& part);

    /// From a point of a face to its patch, and if that is farther than the limit, from more places of the
    /// faces around it as well: surfaces may slide into other patches, and a patch may meet itself. Never
    /// less than the true distance.
    /// \param parameters  of the point in its patch
    [[nodiscard]] double distanceFrom(const Place& point, int face, std::size_t patch,
                                      const Parameters& parameters, double limit) const;

private:
    struct FacePlace {
        std::size_t patch = 0;
        int column = 0;
        int row = 0;
    };

    [[nodiscard]] double distanceToPart(const FacePlace& place, const Place& point, int steps,
                                        double enough) const;
    [[nodiscard]] double distanceToAll(const Place& point, double limit, double nearest) const;

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const SurfacesPart& part_;
    std::vector<FacePlace> places_; ///< by face
};

} // namespace qm::check
