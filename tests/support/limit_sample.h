// Limit surfaces of sample meshes whose vertices lie unevenly.
#pragma once

#include "base/at.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/limit/control_mesh.h"
#include "bspline/reference/limit/limit_surface.h"
#include "bspline/reference/planes/plane_corners.h"
#include "shape/shape.h"
#include "support/quad_layout.h"

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace qm::test {

inline std::vector<bool> noCreases(const QuadMesh& mesh) {
    return std::vector<bool>(mesh.n_edges());
}

/// Every edge that is a crease or lies on the mesh boundary, by edge.
inline std::vector<bool> creasesAndBoundary(const QuadMesh& mesh, std::vector<bool> isCrease) {
    for (const EdgeId edge : mesh.edges())
        if (mesh.is_boundary(edge)) isCrease[at(edge)] = true;
    return isCrease;
}

/// The limit surface with given creases and the rules that they make.
inline std::vector<ReferenceGrid> limitSurface(const QuadMesh& mesh, const Layout& layout,
                                               const std::vector<bool>& isCrease, int steps, unsigned jobs) {
    const auto sharp = creasesAndBoundary(mesh, isCrease);
    return qm::limitSurface(mesh, layout, {vertexRules(mesh, layout, sharp), sharp}, steps, jobs);
}

/// A mesh, and the limit surface of its subdivision on a lattice of four steps an edge.
struct LimitSample {
    QuadMesh mesh;
    std::vector<bool> isCrease;
    std::vector<VertexRule> rules;
    MeshLattice limit;

    explicit LimitSample(const QuadMesh& given) : LimitSample(given, noCreases(given)) {}
    /// \param creases  by edge, besides the boundary
    LimitSample(QuadMesh given, const std::vector<bool>& creases)
        : mesh(std::move(given)), isCrease(creasesAndBoundary(mesh, creases)), limit(mesh, {}) {
        rules = vertexRules(mesh, segmentPerQuad(mesh), isCrease);
        const ControlMesh control = interpolatingControlMesh(mesh, rules);
        MeshLattice lattice(mesh, control.points);
        for (int k = 0; k < 2; ++k)
            lattice = lattice.subdivided(sharpness(), 1);
        limit = lattice.limit(sharpness(), 1);
    }

    [[nodiscard]] Sharpness sharpness() const { return {rules, isCrease}; }

    /// No vertex is bound to a plane.
    [[nodiscard]] PlaneCorners noPlanes() const {
        constexpr double never = -1;
        return {limit, sharpness(), never, 1};
    }
};

inline QuadMesh shape(const std::string& name, int resolution) {
    ShapeOptions options;
    options.resolution = resolution;
    return makeShape(name, options);
}

/// Moves every vertex along its sphere or plane, so that no line remains straight or evenly divided.
template <class Onto> QuadMesh stirred(QuadMesh mesh, double largest, const Onto& onto) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(-largest, largest);
    for (const VertexId vertex : mesh.vertices()) {
        const Point by =
            mesh.is_boundary(vertex) ? Point(0, 0, 0) : Point(shift(random), shift(random), shift(random));
        mesh.set_point(vertex, onto(mesh.point(vertex) + by));
    }
    return mesh;
}

} // namespace qm::test
