#include "support/star_mesh.h"

#include "support/random_graph.h"

#include <cmath>
#include <numbers>

namespace qm::testing {

QuadMesh star(int quads, double turn) {
    check::CheckedMesh mesh{{{0, 0, 0}}, {}};
    const int spokes = turn < 360 ? quads + 1 : quads;
    const auto place = [&](double k, double radius) {
        const double angle = k * turn / quads * std::numbers::pi / 180;
        mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    };
    for (int k = 0; k < spokes; ++k)
        place(k, 1);
    for (int k = 0; k < quads; ++k)
        place(k + 0.5, 1.5);
    for (int k = 0; k < quads; ++k)
        mesh.quads.push_back({0, 1 + k, 1 + spokes + k, 1 + (k + 1) % spokes});
    return quadMesh(mesh);
}

} // namespace qm::testing
