#include "base/keep_marked.h"
#include "base/sort_unique.h"
#include "export/boundary/face_chart.h"
#include "export/boundary/merge.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

namespace qm {
namespace {

using std::numbers::pi;

/// What checks an outline compares all of its edges with one another.
constexpr std::size_t maxEdges = 256;
/// Radians around an axis. The rest is room for the seam.
constexpr double maxTurn = 2 * pi - 0.2;
/// Where faces go all around, they become halves: vertices may be a little beside a half turn.
constexpr double halfTurn = pi + 0.02;

std::size_t startOf(const Boundary& boundary, const EdgeUse& use) {
    return boundary.edges[use.edge].ends.at(use.side());
}

std::size_t endOf(const Boundary& boundary, const EdgeUse& use) {
    return boundary.edges[use.edge].ends.at(1 - use.side());
}

/// Faces of one surface that hang together, and their outline.
class Region {
public:
    Region(const Boundary& boundary, std::size_t face, std::unique_ptr<FaceChart> chart)
        : boundary_(&boundary), chart_(std::move(chart)), faces_{face},
          outline_(boundary.faces[face].loops.front()) {}

    /// Whether the face was added: it has the same surface, and no vertex gets on the outline twice.
    bool add(std::size_t face) {
        std::vector<EdgeUse> outline;
        const auto& uses = boundary_->faces[face].loops.front();
        const auto addOpen = [&](const std::vector<EdgeUse>& from, const std::vector<EdgeUse>& against) {
            for (const EdgeUse& use : from)
                if (std::ranges::find(against, use.edge, &EdgeUse::edge) == against.end())
                    outline.push_back(use);
        };
        addOpen(outline_, uses);
        addOpen(uses, outline_);
        std::vector<std::size_t> starts;
        starts.reserve(outline.size());
        for (const EdgeUse& use : outline)
            starts.push_back(startOf(*boundary_, use));
        std::ranges::sort(starts);
        if (outline.size() > maxEdges || std::ranges::adjacent_find(starts) != starts.end() ||
            !chart_->add(face))
            return false;
        outline_ = std::move(outline);
        faces_.push_back(face);
        return true;
    }

    [[nodiscard]] const std::vector<std::size_t>& faces() const { return faces_; }
    [[nodiscard]] const std::vector<EdgeUse>& outline() const { return outline_; }
    [[nodiscard]] const FaceChart& chart() const { return *chart_; }

    /// The outline as loops, that around all others first.
    [[nodiscard]] std::vector<std::vector<EdgeUse>> loops() const {
        std::vector<std::vector<EdgeUse>> result;
        std::vector<EdgeUse> left = outline_;
        while (!left.empty()) {
            std::vector<EdgeUse>& loop = result.emplace_back();
            auto next = left.begin();
            do {
                loop.push_back(*next);
                left.erase(next);
                next = std::ranges::find(left, endOf(*boundary_, loop.back()),
                                         [&](const EdgeUse& use) { return startOf(*boundary_, use); });
            } while (next != left.end());
        }
        std::ranges::iter_swap(result.begin(), std::ranges::max_element(result, {}, [&](const auto& loop) {
                                   return chart_->area(loop);
                               }));
        return result;
    }

private:
    const Boundary* boundary_;
    std::unique_ptr<FaceChart> chart_;
    std::vector<std::size_t> faces_;
    std::vector<EdgeUse> outline_;
};

/// Regions that grow over faces of one surface.
class Growth {
public:
    /// \param mayGrow  by face: it may be part of a region
    Growth(const Boundary& boundary, MergedSurface kind, const std::vector<bool>& mayGrow)
        : boundary_(boundary), kind_(kind), facesOf_(facesOfEdges(boundary)), taken_(mayGrow) {
        taken_.flip();
    }

    /// Regions of two faces or more.
    std::vector<Region> regions() {
        std::vector<Region> result;
        for (std::size_t face = 0; face < boundary_.faces.size(); ++face) {
            if (taken_[face]) continue;
            std::optional<Region> region = grown(face, maxTurn);
            if (region && region->chart().goesAround()) {
                for (const std::size_t other : region->faces())
                    taken_[other] = false;
                region = grown(face, halfTurn);
            }
            if (region && region->faces().size() > 1) result.push_back(std::move(*region));
        }
        return result;
    }

private:
    /// All that can be added to a face, one by one; what cannot yet is tried again when the region has grown.
    /// \return nothing if the face is of another kind
    std::optional<Region> grown(std::size_t face, double turn) {
        auto chart =
            kind_ == MergedSurface::plane ? planeChart(boundary_, face) : ruledChart(boundary_, face, turn);
        if (!chart) return std::nullopt;
        Region region(boundary_, face, std::move(chart));
        taken_[face] = true;
        for (bool isGrowing = true; isGrowing;) {
            isGrowing = false;
            for (const EdgeUse& use : std::vector(region.outline()))
                for (const std::size_t beside : facesOf_[use.edge])
                    if (!taken_[beside] && region.add(beside)) isGrowing = taken_[beside] = true;
        }
        return region;
    }

    const Boundary& boundary_;
    MergedSurface kind_;
    std::vector<std::vector<std::size_t>> facesOf_; ///< by edge
    std::vector<bool> taken_;                       ///< by face: in a region, or in none at all
};

} // namespace

bool mergeFaces(Boundary& boundary, FaceOrigins& origins, MergedSurface kind,
                const std::vector<bool>& mayMerge) {
    const std::vector<Region> regions = Growth(boundary, kind, mayMerge).regions();
    if (regions.empty()) return false;
    std::vector<bool> isKept(boundary.faces.size(), true);
    std::vector<std::vector<std::vector<EdgeUse>>> loops;
    for (const Region& region : regions) {
        loops.push_back(region.loops());
        const std::size_t first = region.faces().front();
        for (const std::size_t face : region.faces()) {
            isKept[face] = face == first;
            if (face != first)
                origins[first].insert(origins[first].end(), origins[face].begin(), origins[face].end());
        }
        sortUnique(origins[first]);
    }
    for (std::size_t k = 0; k < regions.size(); ++k) {
        const std::size_t face = regions[k].faces().front();
        boundary.faces[face].loops = std::move(loops[k]);
        regions[k].chart().applyTo(boundary, face);
    }
    const auto numbers = keepMarked(boundary.faces, isKept);
    (void)keepMarked(origins, isKept);
    for (BoundaryPart& part : boundary.parts) {
        std::erase_if(part.faces, [&](std::size_t face) { return !isKept[face]; });
        for (std::size_t& face : part.faces)
            face = numbers[face];
    }
    dropUnused(boundary);
    return true;
}

} // namespace qm
