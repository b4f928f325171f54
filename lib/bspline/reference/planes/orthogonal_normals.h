/// \file Directions in which something has to move to get into several planes.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace qm {

/// Makes the normals of planes orthogonal to one another, in the order in which they come: to move along each
/// into its plane does not leave those before.
class OrthogonalNormals {
public:
    /// \return the unit direction for the plane with a normal; nothing if that is nearly parallel to those
    ///         before, as the common line of such planes is uncertain
    std::optional<Eigen::Vector3d> add(const Eigen::Vector3d& normal) {
        constexpr double minSine = 0.1;
        Eigen::Vector3d direction = normal;
        for (const Eigen::Vector3d& other : directions_)
            direction -= direction.dot(other) * other;
        if (direction.norm() < minSine) return std::nullopt;
        return directions_.emplace_back(direction.normalized());
    }

private:
    std::vector<Eigen::Vector3d> directions_;
};

} // namespace qm
