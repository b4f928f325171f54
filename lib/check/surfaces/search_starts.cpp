#include "check/surfaces/search_starts.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace qm::check {
namespace {

namespace index = boost::geometry::index;

/// The parameters of the lattice on a part.
constexpr std::array lattice{0.0, 0.25, 0.5, 0.75, 1.0};

Parameters latticeParameters(std::size_t k) {
    return {lattice[k % lattice.size()], lattice[k / lattice.size()]};
}

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<TreePoint>;
using Entry = std::pair<Box, std::size_t>;

TreePoint treePoint(const Place& place) {
    return {place[0], place[1], place[2]};
}

struct Extent {
    Place low, high;
};

Extent extentOf(const std::vector<Place>& places) {
    Extent extent{places.front(), places.front()};
    for (const Place& place : places)
        for (std::size_t k = 0; k < 3; ++k) {
            extent.low[k] = std::min(extent.low[k], place[k]);
            extent.high[k] = std::max(extent.high[k], place[k]);
        }
    return extent;
}

/// How far the surface may go from the nearest place of a lattice.
double reachOf(const Extent& extent) {
    constexpr double bulge = 1.5; // steps
    return bulge * distance(extent.low, extent.high) / (lattice.size() - 1);
}

Box grown(Extent extent, double by) {
    for (std::size_t k = 0; k < 3; ++k) {
        extent.low[k] -= by;
        extent.high[k] += by;
    }
    return {treePoint(extent.low), treePoint(extent.high)};
}

} // namespace

/// Boxes that contain the parts.
class SearchStarts::Boxes {
public:
    explicit Boxes(const std::vector<Entry>& boxes) : tree_(boxes) {}

    /// Calls a function with the parts within reach of a point, at first with one whose box is nearest.
    /// \param reach  of the others: what the function returned for the first
    template <class Function> void visit(const Place& point, double reach, const Function& function) const {
        std::size_t first = 0;
        const auto shrink = [&](const Entry& entry) {
            reach = std::min(reach, function(first = entry.second));
        };
        tree_.query(index::nearest(treePoint(point), 1), boost::make_function_output_iterator(shrink));
        const auto rest = [&](const Entry& entry) {
            if (entry.second != first) function(entry.second);
        };
        tree_.query(index::intersects(grown({point, point}, reach)),
                    boost::make_function_output_iterator(rest));
    }

private:
    index::rtree<Entry, index::linear<16>> tree_;
};

SearchStarts::SearchStarts(std::size_t parts, LatticeOn latticeOn)
    : parts_(parts), latticeOn_(std::move(latticeOn)) {}

SearchStarts::~SearchStarts() = default;

/// Places on a part, row by row.
std::vector<Place> SearchStarts::latticeOn(std::size_t part) const {
    return latticeOn_(part, lattice);
}

std::vector<Start> SearchStarts::within(double distance, const Place& point) const {
    std::vector<Start> found;
    boxes().visit(point, distance, [&](std::size_t part) {
        const std::vector<Place> places = latticeOn(part);
        const double reach = reachOf(extentOf(places));
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double here = check::distance(places[k], point);
            if (here - reach > distance) continue;
            distance = std::min(distance, here);
            found.push_back({here, reach, part, latticeParameters(k)});
        }
        return distance;
    });
    std::ranges::sort(found, {}, [](const Start& start) {
        return std::tuple(start.distance, start.part, start.parameters);
    });
    return found;
}

const SearchStarts::Boxes& SearchStarts::boxes() const {
    std::call_once(once_, [&] {
        std::vector<Entry> entries;
        for (std::size_t part = 0; part < parts_; ++part) {
            const Extent extent = extentOf(latticeOn(part));
            entries.emplace_back(grown(extent, reachOf(extent)), part);
        }
        boxes_ = std::make_unique<const Boxes>(entries);
    });
    return *boxes_;
}

} // namespace qm::check
