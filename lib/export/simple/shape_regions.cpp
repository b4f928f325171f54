#include "export/simple/shape_regions.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/sort_unique.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <queue>
#include <span>
#include <utility>

namespace qm {
namespace {

struct KindWeight {
    SimpleKind kind;
    /// How much of a region's area counts: the more numbers a surface has, the more it passes by chance.
    double weight;
};

constexpr std::array kinds{KindWeight{SimpleKind::plane, 1}, KindWeight{SimpleKind::cylinder, 0.9},
                           KindWeight{SimpleKind::sphere, 0.8}, KindWeight{SimpleKind::cone, 0.8},
                           KindWeight{SimpleKind::torus, 0.7}};

/// How much less counts what needs all of the tolerance than what fits exactly.
constexpr double weightOfLooseness = 0.5;

/// A region of so many patches is fitted anew with every neighbour that its surface does not pass: that of a
/// few patches is not sure yet.
constexpr std::size_t fewPatches = 3;
/// So often a region is fitted anew to all of its patches, and tries again what its surface did not pass.
constexpr int maxRefits = 6;

/// Gives a region the best surface for all of its points.
/// \return false if that does not lie along them, and nothing has changed
bool fitAnew(ShapeRegion& region) {
    PatchCloud cloud = centred(region.cloud);
    const auto shape =
        fittingShape(region.shape.kind, cloud.samples, region.tolerance / cloud.size, region.limits);
    if (!shape) return false;
    region.shape = *shape;
    region.side = sideOf(*shape, cloud.samples);
    region.cloud = std::move(cloud);
    return true;
}

/// Adds a patch that lies on the region's surface, or with which a surface can be found for all if there are
/// few patches yet.
bool add(ShapeRegion& region, std::size_t patch, const ShapePatches& patches) {
    const PatchCloud& cloud = patches.clouds[patch];
    const double tolerance = patches.tolerances[patch];
    const PatchCloud more = inFrame(cloud, region.cloud.centre, region.cloud.size);
    if (isAlong(region.shape, region.side, more.samples, tolerance / region.cloud.size)) {
        if (!region.isExact) {
            append(region.cloud, cloud);
            region.tolerance = std::min(region.tolerance, tolerance);
        }
    } else {
        if (region.isExact || region.patches.size() > fewPatches) return false;
        ShapeRegion both = region;
        append(both.cloud, cloud);
        both.tolerance = std::min(region.tolerance, tolerance);
        if (!fitAnew(both)) return false;
        region = std::move(both);
    }
    region.patches.push_back(patch);
    region.area += cloud.area;
    return true;
}

/// Every so many points of a cloud, if it has too many for a fit that may well be in vain. Patches are
/// verified one by one at the end.
void thin(OrientedPoints& samples) {
    constexpr std::size_t enough = 20000;
    const std::size_t step = samples.points.size() / enough + 1;
    if (step == 1) return;
    OrientedPoints few;
    for (std::size_t k = 0; k < samples.points.size(); k += step) {
        few.points.push_back(samples.points[k]);
        few.normals.push_back(samples.normals[k]);
    }
    samples = std::move(few);
}

/// Whether the shape of a region is meant; and notes how well it fits.
bool isMeaningful(ShapeRegion& region) {
    region.looseness = farthest(region.shape, region.cloud.samples) * region.cloud.size;
    return region.isExact || isMeant(region.shape, region.cloud.samples);
}

/// All patches that hang together, if they are bent and one surface passes all of them.
std::vector<ShapeRegion> wholeComponents(const ShapePatches& patches) {
    DisjointSets sets(patches.clouds.size());
    for (std::size_t k = 0; k < patches.clouds.size(); ++k)
        for (const std::size_t neighbour : patches.neighbours[k])
            sets.join(k, neighbour);
    const auto isOther = [&](std::size_t k) { // cannot be in a region
        return !(patches.tolerances[k] > 0) || patches.clouds[k].samples.points.empty();
    };
    std::vector<ShapeRegion> result;
    for (const std::vector<std::size_t>& members : sets.members()) {
        if (std::ranges::any_of(members, isOther)) continue;
        const std::size_t first = members.front();
        ShapeRegion component{patches.clouds[first],     {}, members, 1, patches.tolerances[first],
                              patches.clouds[first].area};
        for (const std::size_t k : std::span(members).subspan(1)) {
            append(component.cloud, patches.clouds[k]);
            component.area += patches.clouds[k].area;
            component.tolerance = std::min(component.tolerance, patches.tolerances[k]);
        }
        component.limits = ofWholeComponents;
        thin(component.cloud.samples);
        for (const auto& [kind, weight] : kinds) {
            ShapeRegion region = component;
            region.shape.kind = kind;
            if (fitAnew(region) && isMeaningful(region)) result.push_back(std::move(region));
        }
    }
    return result;
}

/// Grows the regions of one kind.
class Growth {
public:
    Growth(const ShapePatches& patches, SimpleKind kind)
        : patches_(patches), kind_(kind), isTaken_(patches.clouds.size(), false) {}

    std::vector<ShapeRegion> run(const std::vector<std::size_t>& seeds) {
        std::vector<ShapeRegion> result;
        for (const std::size_t seed : seeds) {
            if (isTaken_[seed]) continue;
            auto region = started(seed);
            if (!region) continue;
            grow(*region);
            if (isMeaningful(*region)) result.push_back(std::move(*region));
        }
        return result;
    }

private:
    std::optional<ShapeRegion> started(std::size_t seed) {
        const PatchCloud& cloud = patches_.clouds[seed];
        ShapeRegion region{cloud, {kind_}, {seed}, 1, patches_.tolerances[seed], cloud.area};
        region.isExact = kind_ == SimpleKind::plane && patches_.planes[seed];
        if (region.isExact) {
            region.shape = intoFrame(*patches_.planes[seed], cloud.centre, cloud.size);
            region.side = sideOf(region.shape, cloud.samples);
        } else if (!(region.tolerance > 0) || !fitAnew(region)) {
            return std::nullopt;
        }
        isTaken_[seed] = true;
        return region;
    }

    void grow(ShapeRegion& region) {
        std::vector<std::size_t> next = patches_.neighbours[region.patches.front()];
        for (int refit = 0; refit < maxRefits; ++refit) {
            const std::size_t before = region.patches.size();
            std::vector<std::size_t> refused;
            while (!next.empty()) {
                const std::size_t patch = next.back();
                next.pop_back();
                if (isTaken_[patch] || !(patches_.tolerances[patch] > 0)) continue;
                if (!add(region, patch, patches_)) {
                    refused.push_back(patch);
                    continue;
                }
                isTaken_[patch] = true;
                const auto& more = patches_.neighbours[patch];
                next.insert(next.end(), more.begin(), more.end());
            }
            if (region.isExact || region.patches.size() == before || !fitAnew(region)) return;
            next = std::move(refused);
            sortUnique(next);
        }
    }

    const ShapePatches& patches_;
    SimpleKind kind_;
    std::vector<bool> isTaken_; ///< by patch: in a region of this kind
};

double weightOf(SimpleKind kind) {
    return std::ranges::find(kinds, kind, &KindWeight::kind)->weight;
}

/// Gives every patch to one of the regions that it is in.
std::vector<ShapeRegion> withoutOverlap(std::vector<ShapeRegion> regions, const ShapePatches& patches) {
    const auto score = [&](const ShapeRegion& region) {
        const double used = region.tolerance > 0 ? region.looseness / region.tolerance : 0;
        return region.area * weightOf(region.shape.kind) * (1 - weightOfLooseness * used);
    };
    // The best first, of equal ones the first.
    using Entry = std::pair<double, std::ptrdiff_t>;
    std::priority_queue<Entry> queue;
    for (std::size_t r = 0; r < regions.size(); ++r)
        queue.emplace(score(regions[r]), -static_cast<std::ptrdiff_t>(r));
    std::vector<bool> isTaken(patches.clouds.size(), false);
    std::vector<ShapeRegion> result;
    while (!queue.empty()) {
        const auto [before, number] = queue.top();
        queue.pop();
        ShapeRegion& region = regions[at(-number)];
        std::erase_if(region.patches, [&](std::size_t patch) { return isTaken[patch]; });
        if (region.patches.empty()) continue;
        region.area = 0;
        for (const std::size_t patch : region.patches)
            region.area += patches.clouds[patch].area;
        if (score(region) < before) {
            queue.emplace(score(region), number);
            continue;
        }
        for (const std::size_t patch : region.patches)
            isTaken[patch] = true;
        result.push_back(std::move(region));
    }
    return result;
}

/// Large patches first: their surfaces are known best. Those that are planes exactly before all others.
std::vector<std::size_t> seedsOf(const ShapePatches& patches) {
    std::vector<std::size_t> seeds(patches.clouds.size());
    std::iota(seeds.begin(), seeds.end(), std::size_t{0});
    std::erase_if(seeds, [&](std::size_t k) { return patches.clouds[k].samples.points.empty(); });
    std::ranges::stable_sort(seeds, [&](std::size_t one, std::size_t other) {
        const auto isExact = [&](std::size_t k) { return patches.planes[k].has_value(); };
        return isExact(one) != isExact(other) ? isExact(one)
                                              : patches.clouds[one].area > patches.clouds[other].area;
    });
    return seeds;
}

} // namespace

std::vector<ShapeRegion> shapeRegions(const ShapePatches& patches) {
    const std::vector<std::size_t> seeds = seedsOf(patches);
    std::vector<std::size_t> bent = seeds; // a plane patch says nothing about other surfaces
    std::erase_if(bent, [&](std::size_t k) {
        const PatchCloud& cloud = patches.clouds[k];
        return patches.planes[k] ||
               fittingShape(SimpleKind::plane, cloud.samples, patches.tolerances[k] / cloud.size);
    });
    std::vector<ShapeRegion> regions = wholeComponents(patches);
    for (const auto& [kind, weight] : kinds)
        std::ranges::move(Growth(patches, kind).run(kind == SimpleKind::plane ? seeds : bent),
                          std::back_inserter(regions));
    return withoutOverlap(std::move(regions), patches);
}

} // namespace qm
