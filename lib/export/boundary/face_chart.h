/// \file The surface on which neighbouring faces are one.
#pragma once

#include "export/boundary/boundary.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace qm {

/// Grows with the faces that are added to it.
class FaceChart {
public:
    virtual ~FaceChart() = default;

    /// \param face  shares an edge with one that was added
    /// \return whether the face has this surface and was added
    virtual bool add(std::size_t face) = 0;

    /// Whether a face was refused because all together would go around an axis, or too far.
    [[nodiscard]] virtual bool goesAround() const { return false; }

    /// The area inside a loop of edges, but for a factor that is the same for all; negative for a hole.
    [[nodiscard]] virtual double area(const std::vector<EdgeUse>& loop) const = 0;

    /// Gives a face with all its loops the common surface, and its edges their tolerances and curves there.
    virtual void applyTo(Boundary& boundary, std::size_t face) const = 0;
};

/// The plane of a face; null if it is none. Edges of other faces may be as far away as the boundary's
/// flatness.
/// \param boundary  must outlive the result, and keep its edges until `applyTo`
[[nodiscard]] std::unique_ptr<FaceChart> planeChart(const Boundary& boundary, std::size_t face);

/// The cylinder or cone of a face; null if it is neither. All faces together take at most `maxTurn` radians
/// around the axis.
/// \param boundary  likewise
[[nodiscard]] std::unique_ptr<FaceChart> ruledChart(const Boundary& boundary, std::size_t face,
                                                    double maxTurn);

} // namespace qm
