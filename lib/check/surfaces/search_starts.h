/// \file Where to begin the search for the nearest point of a surface that consists of many parts.
#pragma once

#include "check/mesh/vectors.h"
#include "check/surfaces/spline.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace qm::check {

/// A place on a part from which a search may lead to a nearer one.
struct Start {
    double distance = 0;
    double reach = 0; ///< how far the surface goes from here before another start is nearer, about
    std::size_t part = 0;
    Parameters parameters{}; ///< in the part: both from 0 to 1
};

/// Knows a lattice of places on every part. May be used by several threads.
class SearchStarts {
public:
    /// The places on a part at all pairs of some parameters, the first parameter running faster.
    using LatticeOn = std::function<std::vector<Place>(std::size_t part, std::span<const double> parameters)>;

    SearchStarts(std::size_t parts, LatticeOn latticeOn);
    ~SearchStarts();

    /// All starts whose reach leads to something nearer to the point than a distance, the nearest first:
    /// most searches from there succeed at once, and where the surface is folded, others do.
    [[nodiscard]] std::vector<Start> within(double distance, const Place& point) const;

    /// The smallest distance of a point that searches find, which begin at all these starts; they end with
    /// the first within a limit.
    /// \param nearest  what has been found already
    /// \param search   from a start, for a distance
    template <class Search>
    [[nodiscard]] double nearest(const Place& point, double nearest, double limit,
                                 const Search& search) const {
        for (const Start& start : within(nearest, point)) {
            if (start.distance - start.reach > nearest) continue;
            nearest = std::min(nearest, search(start));
            if (nearest <= limit) break;
        }
        return nearest;
    }

private:
    class Boxes;
    [[nodiscard]] std::vector<Place> latticeOn(std::size_t part) const;
    [[nodiscard]] const Boxes& boxes() const;

    std::size_t parts_;
    LatticeOn latticeOn_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const Boxes> boxes_; ///< around the parts; made when needed
};

} // namespace qm::check
