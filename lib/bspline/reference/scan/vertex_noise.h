/// \file The noise of a scan, from its vertices alone (docs/METHOD.md#reference).
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace qm {

/// How far vertices are off the smooth surface through those around them, where the scan is smooth: what is
/// left of them along their normals after the surface's curvature, which neighbours share, is taken away.
/// Every vertex of small scans is asked, and many of large ones; linear in the scan.
/// \param normals  by point, of unit length or 0
/// \return the standard deviation; nothing if too few vertices lie in smooth places, as in models of large
///         facets
[[nodiscard]] std::optional<double> vertexNoise(const std::vector<Eigen::Vector3d>& points,
                                                const std::vector<std::array<int, 3>>& faces,
                                                const std::vector<Eigen::Vector3d>& normals);

} // namespace qm
