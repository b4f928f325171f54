/// \file How far a point of the surfaces is from a mesh.
#pragma once

#include "check/surfaces/distance.h"
#include "check/surfaces/search_starts.h"

namespace qm::check {

/// From points to a mesh whose quads are bilinear.
class DistanceToMesh {
public:
    /// \param mesh  must outlive this
    explicit DistanceToMesh(const CheckedMesh& mesh);

    /// To a face, and if that is farther than the limit, to whatever may be nearer. Never less than the true
    /// distance.
    /// \param start  parameters in the face
    [[nodiscard]] double from(const Place& point, int face, const Parameters& start, double limit = 0) const;

private:
    const CheckedMesh& mesh_;
    SearchStarts starts_; ///< on faces
};

} // namespace qm::check
