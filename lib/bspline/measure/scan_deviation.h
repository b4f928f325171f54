/// \file The largest distance between surfaces and a scan, certain to a few per cent where that is possible.
#pragma once

#include "bspline/measure/certified_deviation.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <functional>
#include <vector>

namespace qm {

/// The nearest point of a triangulated scan.
struct ScanPoint {
    std::array<Point, 3> triangle; ///< on which it lies
    double distance = 0;
    bool onBoundary = false; ///< the scan ends there, so it says nothing about the place that was asked for
};
/// Of any point; from several threads.
using NearestOnScan = std::function<ScanPoint(const Point&)>;

struct ScanDeviation {
    CertifiedDeviation deviation; ///< of the part that the scan covers, from surface to scan
    double covered = 0;           ///< share of the parameters' area
};

/// Branch and bound over the Bezier pieces of a patch: the distance from a triangle is convex, so that of a
/// piece is at most that of its Bezier points. Places whose nearest point lies on the scan's boundary or
/// beyond the cut-off are not covered.
/// \param cutOff  distance beyond which the scan says nothing of the surface
[[nodiscard]] ScanDeviation scanDeviation(const Patch& patch, std::size_t number,
                                          const NearestOnScan& nearest, double cutOff,
                                          const CertificationOptions& options);

/// Of all patches from a scan.
struct ScanDeviations {
    /// The largest that was found: boxes over many small triangles are bounded too loosely for an upper
    /// bound.
    double max = 0;
    double rms = 0;
    double percentile95 = 0;
    double covered = 0; ///< mean share of the patches' parameters
    LayoutPlace farthest;
};

[[nodiscard]] ScanDeviations deviationFromScan(const std::vector<Patch>& patches,
                                               const NearestOnScan& nearest, double cutOff,
                                               const CertificationOptions& options, unsigned jobs);

[[nodiscard]] double distanceToTriangle(const std::array<Point, 3>& triangle, const Point& point);

} // namespace qm
