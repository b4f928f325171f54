/// \file Solids and sheets that OpenCASCADE takes, with as simple faces as it allows.
#pragma once

#include "export/boundary/boundary.h"
#include "export/faces/face_patches.h"
#include "export/files/shape.h"

#include <optional>
#include <vector>

namespace qm {

struct CheckedShape {
    Boundary boundary;
    FaceOrigins origins;
    BoundaryShape shape;
    bool isValid = false; ///< OpenCASCADE finds no faults
    /// By face: OpenCASCADE finds no faults, and the outline of a simple face does not cross itself.
    std::vector<bool> isFaceSound{};

    [[nodiscard]] bool isSound() const;
};

/// Gives a simple surface up where its borders do not allow it, and leaves faces and edges apart where
/// OpenCASCADE does not take them as one. In the end, edges are divided (divided_edges.h), if it takes that:
/// those along which faces twist, and with `simplify` those that are off simple surfaces.
/// \param simplify  largest distance between a patch and the simple surface that replaces it; if nothing, only
/// exact planes do
/// \param join      makes one face for every plane, cylinder and cone, and one edge for what is one line,
/// circle or ellipse
[[nodiscard]] CheckedShape checkedShape(const QuadMesh& mesh, const FacePatches& faces,
                                        std::optional<double> simplify, bool join);

} // namespace qm
