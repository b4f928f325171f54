/// \file What somebody who needs the surfaces asks first: how many patches, how good, and where they are not.
#pragma once

#include "bspline/fit.h"
#include "mesh/boundary_loops.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// STEP files say how close points must be to be one; this is what ours say where nothing is farther apart.
constexpr double stepTolerance = 1e-7;

/// A place on the surfaces, and its point.
struct SurfacePlace {
    LayoutPlace place;
    Point point{0, 0, 0};
};

/// The vertex that surfaces fitted to a mesh are farthest from, where the quads around are folded and the
/// reference does not pass through it (docs/METHOD.md#reference).
struct BridgedVertex {
    double distance = 0;
    std::size_t patch = 0;
};

/// \param allowed  distance from the reference
/// \return nothing if the surfaces are that near to every vertex, or were fitted to a scan
[[nodiscard]] std::optional<BridgedVertex> bridgedVertex(const Surfaces& surfaces, double allowed);

/// Figures of surfaces that were fitted.
struct FitSummary {
    bool smooth = true;   ///< Fit::smooth, which heeds a tolerance and leaves no gaps
    double tolerance = 0; ///< in the mesh's unit; of a smooth fit; with what is left of a scan's noise
    Deviation deviation;
    std::optional<ScanFigures> scan;      ///< that the surfaces were fitted to
    SurfacePlace farthest;                ///< where deviation.max was found
    SurfacePlace farthestFromScan;        ///< where scan->max was found
    std::optional<SurfacePlace> fold;     ///< the first place that may fold
    std::optional<BridgedVertex> bridged; ///< of a smooth fit
};

/// Of a mesh and, as far as there are any, its layout and surfaces. Lengths are in the mesh's unit.
struct Summary {
    std::size_t quads = 0;
    std::size_t vertices = 0;
    std::size_t pieces = 0;   ///< connected components that have faces
    std::size_t cavities = 0; ///< of a closed mesh: those of them that are no solids, but cavities of one
    std::vector<BoundaryLoop> loops;
    std::array<double, 3> size{}; ///< of the bounding box of all faces
    double diagonal = 0;
    std::optional<std::size_t> patches;
    std::optional<FitSummary> fit;
};

/// \param layout, surfaces  null if there are none
/// \param fit  what the surfaces were fitted with
[[nodiscard]] Summary summarise(const QuadMesh& mesh, const Layout* layout, const Surfaces* surfaces,
                                const FitOptions& fit);

/// Closed, and without gaps that a STEP reader would see.
[[nodiscard]] bool isSolid(const Summary& summary);

/// What a result must keep to.
struct Limits {
    std::optional<std::size_t> maxPatches;
    double maxNormalAngle = 1; ///< across the borders that a smooth fit makes smooth, degrees
};

/// Every limit that is not met, as a sentence with figures and place.
/// \param unit  of the mesh, behind lengths
[[nodiscard]] std::vector<std::string> unmetLimits(const Summary& summary, const Limits& limits,
                                                   const std::string& unit);

/// A few lines of at most 80 columns, but for names.
/// \param name  of the mesh
/// \param seconds  that it took to make the surfaces, if known
[[nodiscard]] std::string summaryText(const Summary& summary, const std::string& name,
                                      const std::string& unit, std::optional<double> seconds);

} // namespace qm
