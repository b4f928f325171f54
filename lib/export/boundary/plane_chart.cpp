#include "export/boundary/face_chart.h"

#include <Geom_Plane.hxx>
#include <algorithm>
#include <gp_Pln.hxx>

namespace qm {
namespace {

/// Largest angle between the normals of two planes that are one, in radians; how far edges are apart counts
/// besides.
constexpr double maxAngle = 1e-3;
/// Between the normals of what is one plane, but for rounding.
constexpr double sameAngle = 1e-12;

/// The largest distance of an edge's control points from a plane: no point of it is farther away.
double distance(const BoundaryEdge& edge, const gp_Pln& plane) {
    double largest = 0;
    for (const gp_Pnt& point : controlPoints(edge.curve))
        largest = std::max(largest, plane.Distance(point));
    return largest;
}

class PlaneChart final : public FaceChart {
public:
    PlaneChart(const Boundary& boundary, const gp_Pln& plane) : boundary_(boundary), plane_(plane) {}

    bool add(std::size_t face) override {
        const auto plane = Handle(Geom_Plane)::DownCast(boundary_.faces[face].surface);
        if (plane.IsNull() || plane->Axis().Direction().Angle(plane_.Axis().Direction()) > maxAngle)
            return false;
        // One plane for all: where its edges are farther away, so they were before.
        if (plane->Axis().Direction().Angle(plane_.Axis().Direction()) <= sameAngle &&
            plane_.Distance(plane->Location()) <= boundary_.resolution / 2)
            return true;
        return std::ranges::all_of(boundary_.faces[face].loops.front(), [&](const EdgeUse& use) {
            return distance(boundary_.edges[use.edge], plane_) <= boundary_.flatness;
        });
    }

    /// Twice the area; control points stand in for curves.
    [[nodiscard]] double area(const std::vector<EdgeUse>& loop) const override {
        gp_XYZ sum(0, 0, 0);
        const gp_XYZ origin = plane_.Location().XYZ();
        for (const EdgeUse& use : loop) {
            const std::vector<gp_Pnt> points = controlPoints(boundary_.edges[use.edge].curve);
            for (std::size_t k = 1; k < points.size(); ++k) {
                const gp_XYZ cross = (points[k - 1].XYZ() - origin).Crossed(points[k].XYZ() - origin);
                sum += use.forwards ? cross : cross.Reversed();
            }
        }
        return sum.Dot(plane_.Axis().Direction().XYZ());
    }

    void applyTo(Boundary& boundary, std::size_t face) const override {
        for (const auto& loop : boundary.faces[face].loops)
            for (const EdgeUse& use : loop)
                raiseTolerance(boundary, use.edge, distance(boundary.edges[use.edge], plane_));
    }

private:
    const Boundary& boundary_;
    gp_Pln plane_;
};

} // namespace

std::unique_ptr<FaceChart> planeChart(const Boundary& boundary, std::size_t face) {
    const auto plane = Handle(Geom_Plane)::DownCast(boundary.faces[face].surface);
    if (plane.IsNull()) return nullptr;
    return std::make_unique<PlaneChart>(boundary, plane->Pln());
}

} // namespace qm
