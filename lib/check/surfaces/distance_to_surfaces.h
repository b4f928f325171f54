/// \file How far a point of a mesh is from the surfaces that were fitted to it.
#pragma once

#include "check/surfaces/distance.h"
#include "check/surfaces/search_starts.h"

#include <cstddef>
#include <vector>

namespace qm::check {

/// Knows which patch lies over every face.
class DistanceToSurfaces {
public:
    /// \param part  must outlive this
    DistanceToSurfaces(const CheckedMesh& mesh, const LayoutPart& layout, const SurfacesPart& part);

    /// From a point to a patch, and if that is farther than the limit, to whatever may be nearer: surfaces
    /// may slide into other patches, a patch may meet itself, and a reference of another shape draws surfaces
    /// away from their faces. Never less than the true distance.
    /// \param parameters  of the point in the patch, about
    [[nodiscard]] double from(const Place& point, std::size_t patch, const Parameters& parameters,
                              double limit) const;

private:
    struct FacePlace {
        std::size_t patch = 0;
        int column = 0;
        int row = 0;
    };

    /// \param within  the face: both parameters from 0 to 1
    [[nodiscard]] Parameters inPatch(std::size_t face, const Parameters& within) const;

    const SurfacesPart& part_;
    std::vector<FacePlace> places_; ///< by face
    SearchStarts starts_;           ///< over faces
};

} // namespace qm::check
