/// \file Layouts and surfaces as files for other programs.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/files/export_options.h"
#include "layout/layout.h"

#include <cstddef>
#include <optional>
#include <string>

namespace qm {

/// The result of OpenCASCADE's own check of a boundary representation.
struct ShapeReport {
    std::size_t faces = 0;
    std::size_t edges = 0;
    std::size_t openEdges = 0; ///< number of edges with a face on one side only
    /// Number of edges whose faces' normals differ by less than 0.01 radians: readers take them for smooth.
    std::size_t smoothEdges = 0;
    /// Largest angle between faces, in degrees, where patches that met smoothly became simple surfaces.
    double largestNewAngle = 0;
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
