#include "layout/quality.h"

#include "base/at.h"
#include "base/order_statistics.h"

#include <algorithm>

namespace qm {
namespace {

/// The share of the sharp edges' angles that lies on tracks; 1 if no edge is sharp.
double capturedSharpness(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& angles,
                         double rho) {
    double all = 0, captured = 0;
    for (const double angle : angles)
        if (angle > rho) all += angle;
    for (const LayoutTrack& track : layout.tracks)
        for (const HalfedgeId halfedge : track.track.halfedges) {
            const double angle = angles[at(mesh.edge_handle(halfedge))];
            if (angle > rho) captured += angle;
        }
    // The two sums add in different orders, so rounding may lift the part above the whole.
    return all > 0 ? std::min(captured / all, 1.0) : 1;
}

/// The number of vertices strictly inside a side of one segment that are a corner of another.
std::size_t countTJoints(const QuadMesh& mesh, const Layout& layout) {
    std::vector<bool> isOpen = cornerMarks(mesh, layout); // corners that are not counted yet
    std::size_t count = 0;
    for (const Segment& segment : layout.segments)
        for (const auto& side : segment.sides)
            for (std::size_t k = 1; k + 1 < side.size(); ++k) {
                if (!isOpen[at(side[k])]) continue;
                isOpen[at(side[k])] = false;
                ++count;
            }
    return count;
}

} // namespace

LayoutQuality measureLayout(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<double>& dihedralAngles, double rho) {
    LayoutQuality quality;
    quality.segments = layout.segments.size();
    quality.tJoints = countTJoints(mesh, layout);
    quality.capturedSharpness = capturedSharpness(mesh, layout, dihedralAngles, rho);
    std::vector<double> aspects;
    for (const Segment& segment : layout.segments) {
        const auto [shorter, longer] = std::minmax(segment.size[0], segment.size[1]);
        aspects.push_back(static_cast<double>(longer) / shorter);
    }
    if (aspects.empty()) return quality;
    quality.medianAspect = median(aspects);
    quality.maxAspect = std::ranges::max(aspects);
    return quality;
}

} // namespace qm
