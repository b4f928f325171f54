#include "bspline/tolerance.h"

#include "base/parallel.h"
#include "bspline/interpolate.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

namespace qm {

ToleranceFit::ToleranceFit(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho, double tolerance,
                           double tangency, std::size_t mostPoints, unsigned jobs)
    : mesh_(mesh), layout_(layout), tolerance_(tolerance), jobs_(jobs),
      curves_(mesh, layout, dihedralAngles, rho, tolerance, tangency, jobs), closeness_(mesh.n_vertices()),
      patches_(layout.segments.size()) {
    curves_.fit(std::vector<bool>(curves_.chains().all().size(), true), closeness_);
    fitPatches(std::vector<bool>(patches_.size(), true), mostPoints);
}

std::vector<bool> ToleranceFit::tighten(const DeviatingPlaces& places) {
    constexpr int fewCalls = 5;
    ++calls_;
    const auto before = closeness_;
    comeCloser(places);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (std::ranges::any_of(places[k], [](const auto& place) { return place.distance == 0; }))
            curves_.loosen(k);
        if (calls_ <= fewCalls || (calls_ <= fewCalls + 3 && places[k].empty())) continue;
        for (const VertexId vertex : vertexGrid(mesh_, layout_.segments[k]))
            closeness_[static_cast<std::size_t>(vertex.idx())] = {1, false};
    }
    const auto changed = [&](VertexId vertex) {
        const auto k = static_cast<std::size_t>(vertex.idx());
        return closeness_[k] != before[k];
    };
    const auto& all = curves_.chains().all();
    std::vector<bool> chains(all.size());
    for (std::size_t k = 0; k < chains.size(); ++k)
        chains[k] = std::ranges::any_of(all[k].halfedges, [&](HalfedgeId halfedge) {
            return changed(mesh_.from_vertex_handle(halfedge)) || changed(mesh_.to_vertex_handle(halfedge));
        });
    curves_.fit(chains, closeness_);
    std::vector<bool> patches(patches_.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
        patches[k] = curves_.touches(k, chains) ||
                     std::ranges::any_of(vertexGrid(mesh_, layout_.segments[k]), changed);
    fitPatches(patches, std::numeric_limits<std::size_t>::max());
    return patches;
}

void ToleranceFit::fitPatches(const std::vector<bool>& which, std::size_t mostPoints) {
    std::atomic<std::size_t> points = 0;
    parallelFor(patches_.size(), jobs_, [&](std::size_t k) {
        if (!which[k] || points > mostPoints) return;
        replace(k, fitPatch(input(k), tolerance_));
        points += patches_[k].controlPoints.size();
    });
    complete_ = points <= mostPoints; // in whatever order they were counted
}

PatchFitInput ToleranceFit::input(std::size_t patch) const {
    const Segment& segment = layout_.segments[patch];
    PatchFitInput input;
    input.size = segment.size;
    input.grid = pointGrid(mesh_, segment);
    for (const VertexId vertex : vertexGrid(mesh_, segment))
        input.closeness.push_back(closeness_[static_cast<std::size_t>(vertex.idx())]);
    input.border = onBorder<SplineCurve>([&](int side, bool turned) {
        SplineCurve curve = curves_.side(patch, side);
        return turned ? reversed(curve) : curve;
    });
    input.normals = onBorder<std::vector<Point>>([&](int side, bool turned) {
        std::vector<Point> normals = curves_.normals(patch, side);
        if (turned) std::reverse(normals.begin(), normals.end());
        return normals;
    });
    return input;
}

void ToleranceFit::replace(std::size_t patch, Patch by) {
    patches_[patch] = std::move(by);
    patches_[patch].segment = SegmentId(patch);
}

void ToleranceFit::comeCloser(const DeviatingPlaces& places) {
    qm::comeCloser(mesh_, layout_, places, tolerance_, closeness_);
}

} // namespace qm
