#include "support/star_mesh.h"

#include "support/random_graph.h"

#include <cmath>
#include <numbers>

namespace qm::test {

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

QuadMesh bentFan(int quads) {
    QuadMesh mesh;
    const auto place = [](double radius, double angle) {
        const double x = radius * std::cos(angle);
        const double y = radius * std::sin(angle);
        return Point(x, y, 0.2 * x * x - 0.1 * x * y);
    };
    mesh.add_vertex(place(0, 0));
    for (int ring = 1; ring <= 3; ++ring)
        for (int k = 0; k < 2 * quads; ++k)
            mesh.add_vertex(place(ring * (k % 2 == 0 ? 1 : 1.3), std::numbers::pi * k / quads));
    const auto vertex = [quads](int ring, int k) {
        return VertexId(1 + (ring - 1) * 2 * quads + k % (2 * quads));
    };
    for (int k = 0; k < 2 * quads; k += 2)
        mesh.add_face({VertexId(0), vertex(1, k), vertex(1, k + 1), vertex(1, k + 2)});
    for (int ring = 1; ring < 3; ++ring)
        for (int k = 0; k < 2 * quads; ++k)
            mesh.add_face(
                {vertex(ring, k), vertex(ring + 1, k), vertex(ring + 1, k + 1), vertex(ring, k + 1)});
    return mesh;
}

QuadMesh dividedFan(int triangles, double height, const std::array<FanRing, 4>& rings) {
    check::CheckedMesh mesh{{{0, 0, height}}, {}};
    const auto ring = [&](int count, double first, const FanRing& on) {
        const auto begin = static_cast<int>(mesh.points.size());
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * (k + first) / count;
            mesh.points.push_back({on.radius * std::cos(angle), on.radius * std::sin(angle), on.height});
        }
        return [=](int k) { return begin + k % count; };
    };
    const auto spoke = ring(triangles, 0, rings[0]);
    const auto middle = ring(triangles, 0.5, rings[1]);
    const auto rim = ring(2 * triangles, 0, rings[2]);
    const auto outer = ring(2 * triangles, 0, rings[3]);
    for (int k = 0; k < triangles; ++k) {
        mesh.quads.push_back({0, spoke(k), middle(k), spoke(k + 1)});
        mesh.quads.push_back({spoke(k), rim(2 * k), rim(2 * k + 1), middle(k)});
        mesh.quads.push_back({middle(k), rim(2 * k + 1), rim(2 * k + 2), spoke(k + 1)});
    }
    for (int k = 0; k < 2 * triangles; ++k)
        mesh.quads.push_back({rim(k), outer(k), outer(k + 1), rim(k + 1)});
    return quadMesh(mesh);
}

} // namespace qm::test
