#include "check/mesh/angles.h"

#include "base/at.h"
#include "check/mesh/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm::check {

namespace {

/// The same direction, its largest component 1, so that products stay in range whatever the unit.
Vector scaled(const Vector& vector) {
    const double size = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
    return size > 0 ? Vector{vector[0] / size, vector[1] / size, vector[2] / size} : vector;
}

struct Normal {
    Vector direction{}; ///< not of unit length; zero if there is none
    bool doubtful = false;
};

/// Of unit length; zero if the triangle has no area.
Normal triangleNormal(const Vector& a, const Vector& b, const Vector& c) {
    const Vector first = scaled(minus(b, a));
    const Vector second = scaled(minus(c, a));
    const Vector normal = cross(first, second);
    const double length = std::sqrt(dot(normal, normal));
    const double scale = std::sqrt(dot(first, first) * dot(second, second));
    if (length == 0 || !std::isfinite(length)) return {{}, scale > 0};
    return {{normal[0] / length, normal[1] / length, normal[2] / length}, length < 1e-10 * scale};
}

Normal faceNormal(const CheckedMesh& mesh, std::size_t face) {
    const auto& quad = mesh.quads[face];
    const auto point = [&](std::size_t corner) { return mesh.points[at(quad[corner])]; };
    const Normal first = triangleNormal(point(0), point(1), point(2));
    const Normal second = triangleNormal(point(0), point(2), point(3));
    Normal sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum.direction[i] = first.direction[i] + second.direction[i];
    const bool any = dot(first.direction, first.direction) + dot(second.direction, second.direction) > 0;
    sum.doubtful = first.doubtful || second.doubtful || (any && dot(sum.direction, sum.direction) < 1e-12);
    return sum;
}

} // namespace

Angles dihedralAngles(const CheckedMesh& mesh, const Neighbourhoods& around) {
    std::vector<Normal> normals(mesh.quads.size());
    for (std::size_t face = 0; face < normals.size(); ++face)
        normals[face] = faceNormal(mesh, face);

    const std::size_t edgeCount = at(around.edges());
    Angles angles{std::vector<double>(edgeCount, 0), std::vector<double>(edgeCount, 0)};
    for (int step = 0; step < around.steps(); ++step) {
        if (around.boundary(step)) continue;
        const std::size_t edge = at(around.edge(step));
        const Normal& left = normals[at(around.leftFace(step))];
        const Normal& right = normals[at(around.leftFace(around.back(step)))];
        if (left.doubtful || right.doubtful) angles.doubt[edge] = std::numbers::pi;
        const Vector sine = cross(left.direction, right.direction);
        // Both are zero beside a face without a normal, and so is the angle; of -0 it would be pi.
        const double cosine = dot(left.direction, right.direction) + 0.0;
        angles.angle[edge] = std::atan2(length(sine), cosine);
    }
    return angles;
}

EdgeCosts edgeCosts(const Angles& angles, double alpha, double epsilon) {
    EdgeCosts costs;
    for (std::size_t edge = 0; edge < angles.angle.size(); ++edge) {
        const double angle = angles.angle[edge];
        const bool onTheLimit = std::abs(angle - epsilon) <= 1e-9 + angles.doubt[edge];
        costs.cost.push_back(-angle + (angle < epsilon ? alpha : 0));
        costs.doubt.push_back(angles.doubt[edge] + (onTheLimit ? std::abs(alpha) : 0));
    }
    return costs;
}

EdgeCosts edgeCosts(const CheckedMesh& mesh, const Neighbourhoods& around, const Angles& angles,
                    const CostWeights& weights, const ConstraintsPart& constraints) {
    EdgeCosts costs = edgeCosts(angles, weights.alpha, weights.epsilon);
    for (std::size_t edge = 0; edge < costs.cost.size(); ++edge) {
        costs.cost[edge] *= weights.dihedral;
        costs.doubt[edge] *= std::abs(weights.dihedral);
    }
    for (int step = 0; step < around.steps(); ++step) {
        if (around.boundary(step) || around.from(step) > around.to(step)) continue;
        const auto along = minus(mesh.points[at(around.to(step))], mesh.points[at(around.from(step))]);
        costs.cost[at(around.edge(step))] += weights.length * length(along);
    }
    for (const ConstraintsPart::Weight& entry : constraints.weights)
        for (std::size_t i = 1; i < entry.vertices.size(); ++i)
            costs.cost[at(around.edge(around.stepBetween(entry.vertices[i - 1], entry.vertices[i])))] +=
                weights.custom * entry.weight;
    return costs;
}

bool CostSum::equals(double claimed) const {
    return std::abs(cost_ - claimed) <= 1e-6 * std::max(1.0, std::abs(cost_)) + doubt_;
}

} // namespace qm::check
