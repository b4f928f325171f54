/// \file Solids and sheets that OpenCASCADE takes, with as simple faces as it allows.
#pragma once

#include "export/boundary/boundary.h"
#include "export/faces/face_patches.h"
#include "export/files/shape.h"

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

/// A simple surface is given up where its borders do not allow it.
/// \param simplify  largest distance between a patch and the simple surface that replaces it; 0 allows only
/// exact planes
[[nodiscard]] CheckedShape checkedShape(const QuadMesh& mesh, const FacePatches& faces, double simplify);

/// The same with one face for every plane, cylinder and cone, and one edge for what is one line, circle or
/// ellipse, as far as OpenCASCADE takes that.
[[nodiscard]] CheckedShape merged(CheckedShape shape);

/// The same with edges divided where they are farthest from simple surfaces (divided_edges.h), if OpenCASCADE
/// takes that.
[[nodiscard]] CheckedShape withLooseEdgesDivided(CheckedShape shape);

/// The same with edges divided along which faces twist (divided_edges.h), if OpenCASCADE takes that.
[[nodiscard]] CheckedShape withTwistedEdgesDivided(CheckedShape shape);

} // namespace qm
