/// \file Layouts and surfaces as files for other programs.
#pragma once

#include "base/length.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <cstddef>
#include <optional>
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

/// The result of OpenCASCADE's own check of a boundary representation.
struct ShapeReport {
    std::size_t faces = 0;
    std::size_t edges = 0;
    std::size_t openEdges = 0; ///< number of edges with a face on one side only
    /// Number of edges whose faces' normals differ by less than 0.01 radians: readers take them for smooth.
    std::size_t smoothEdges = 0;
    std::size_t simpleFaces = 0; ///< number of planes, cylinders, cones, spheres and tori
    std::size_t solids = 0;      ///< number of closed components that are no cavities
    std::size_t cavities = 0;    ///< number of closed components inside of solids, which look the other way
    std::size_t shells = 0;      ///< number of open components
    std::size_t lostEdges = 0;   ///< number of edges shorter than `resolution`, which readers may lose
    bool valid = false;
    double resolution = 0; ///< closer points are one in this format; in the mesh's unit
    double largestGap = 0; ///< between neighbouring patches
    /// The largest gap that an edge or vertex bridges. If it is above one millimetre, readers made with
    /// OpenCASCADE search for the edge on the surfaces again, and may not find it.
    double largestTolerance = 0;
};

struct Exported {
    std::string bytes;                ///< the whole file
    std::optional<ShapeReport> shape; ///< for STEP and IGES
};

/// The same input and options give the same bytes. Segments keep their numbers: as names of faces (STEP, at
/// most 49 bytes), labels (IGES), groups (OBJ), a property of faces (PLY) or names of nodes (glTF).
/// \param surfaces  may be null for OBJ, PLY and glTF
/// \throw Error  if surfaces are needed but missing, do not belong to the layout, or cannot be represented in
/// OpenCASCADE
[[nodiscard]] Exported exportModel(const QuadMesh& mesh, const Layout& layout, const Surfaces* surfaces,
                                   const ExportOptions& options);

} // namespace qm
