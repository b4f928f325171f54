/// \file What an exported file is to contain, and how.
#pragma once

#include "base/length.h"

#include <string>

namespace qm {

enum class ExportFormat {
    step, ///< surfaces: STEP AP214, one shell of B-spline faces, a solid where it is closed
    iges, ///< surfaces: IGES 5.3, likewise
    obj,  ///< quads, one group for every segment
    ply,  ///< quads with colours and the number of their segment; binary
    glb   ///< glTF 2.0: triangles with colours, one node for every segment; binary
};

/// What one unit of the mesh's coordinates means in STEP and IGES; numbers are never converted.
enum class LengthUnit { mm, cm, m, inch };

enum class ColourBy {
    segment,  ///< another colour for every segment
    deviation ///< blue to red by the patch's largest deviation; needs surfaces
};

struct ExportOptions {
    ExportFormat format = ExportFormat::step;
    LengthUnit unit = LengthUnit::mm;
    ColourBy colour = ColourBy::segment; ///< PLY and glTF
    /// STEP and IGES: neighbours that are one surface, or one plane, become one face, and edges that are one
    /// line, circle or ellipse one edge.
    bool join = false;
    /// STEP and IGES: patches become cylinders, cones and so on where they can, and the edges between them
    /// lines, circles and ellipses.
    bool analytic = false;
    /// Largest distance between a patch and the surface that replaces it; the default equals that of fits.
    Length analyticTolerance{0.1, true};
    std::string name = "quadmesh";            ///< STEP and IGES: of the product; UTF-8
    std::string date = "1970-01-01T00:00:00"; ///< STEP and IGES: when the file was made
};

} // namespace qm
