/// \file Places on two surfaces from which their distance is taken.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/triangles/triangles.h"

#include <array>
#include <vector>

namespace qm {

/// A place on a scan, which stands for an area around it.
struct ScanSample {
    Point position{0, 0, 0};
    Point normal{0, 0, 0}; ///< of its triangle, of unit length
    double area = 0;
};

/// Evenly over all triangles, large ones in pieces of at most `area`; of very many small ones only every
/// second, third and so on, so that there are about `count` of them. Triangles without area have none.
[[nodiscard]] std::vector<ScanSample> samplesOfScan(const Triangles& scan, double area, std::size_t count);

/// A place on a quad mesh: a mean of vertices, so that it moves with them.
struct QuadSample {
    std::array<int, 4> vertices{};
    std::array<double, 4> weights{};
    double area = 0;
    bool onBoundary = false; ///< of the mesh
};

/// Both halves of all quads, in their order.
[[nodiscard]] Triangles halves(const QuadMesh& mesh);

/// Nine inside every quad; of sides on the boundary three each, which stand for no area but that of a strip.
[[nodiscard]] std::vector<QuadSample> samplesOfQuads(const QuadMesh& mesh);

} // namespace qm
