#include "base/infinity.h"
#include "export/boundary/face_chart.h"
#include "export/simple/curve_on_surface.h"
#include "export/simple/straight_seam.h"

#include <Geom_ElementarySurface.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <map>
#include <numbers>
#include <utility>

namespace qm {
namespace {

using std::numbers::pi;

/// Angles around the axis are those of the first face's surface, and go on across its seam.
class RuledChart final : public FaceChart {
public:
    RuledChart(const Boundary& boundary, std::size_t face, double maxTurn)
        : boundary_(boundary), surface_(surfaceOf(face)), reversed_(boundary.faces[face].reversed),
          maxTurn_(maxTurn) {
        take(face, 0);
    }

    bool add(std::size_t face) override {
        const SimpleSurface other = surfaceOf(face);
        if (other.surface.IsNull() || boundary_.faces[face].reversed != reversed_ ||
            !areOneRuledSurface(surface_, other, boundary_.resolution))
            return false;
        const gp_Ax3& axes = surface_.surface->Position();
        double shift =
            axes.XDirection().AngleWithRef(other.surface->Position().XDirection(), axes.Direction());
        // Common vertices say in which turn the face is; around the axis they disagree.
        bool isKnown = false;
        for (const auto& [vertex, angle] : anglesAt(face)) {
            const auto known = angleAt_.find(vertex);
            if (known == angleAt_.end()) continue;
            const double turns = std::round((known->second - angle - shift) / (2 * pi));
            if (isKnown && turns != 0) {
                goesAround_ = true;
                return false;
            }
            shift += turns * 2 * pi;
            isKnown = true;
        }
        return isKnown && take(face, shift);
    }

    [[nodiscard]] bool goesAround() const override { return goesAround_; }

    /// Twice the area in the parameter plane.
    [[nodiscard]] double area(const std::vector<EdgeUse>& loop) const override {
        double sum = 0;
        for (const EdgeUse& use : loop) {
            const auto& edge = boundary_.edges[use.edge];
            gp_Pnt2d from(angleAt_.at(edge.ends[0]), parametersAt(surface_.surface, edge.curve.start()).Y());
            double twice = 0;
            for (const double parameter : parametersOf(edge.curve, 4)) {
                gp_Pnt2d to = parametersAt(surface_.surface, edge.curve.at(parameter));
                to.SetX(angleNear(to.X(), from.X()));
                twice += from.X() * to.Y() - to.X() * from.Y();
                from = to;
            }
            sum += use.forwards ? twice : -twice;
        }
        return reversed_ ? -sum : sum;
    }

    void applyTo(Boundary& boundary, std::size_t face) const override {
        SimpleSurface turned = surface_;
        const gp_Ax1& axis = surface_.surface->Axis();
        const double opposite = (minAngle_ + maxAngle_) / 2 - pi; // where the seam is to be
        turned.surface = Handle(Geom_ElementarySurface)::DownCast(surface_.surface->Rotated(axis, opposite));
        boundary.faces[face].surface = turned.surface;
        for (const auto& loop : boundary.faces[face].loops)
            for (const EdgeUse& use : loop) {
                BoundaryEdge& edge = boundary.edges[use.edge];
                const CurveOnSurface found = curveOnSurface(edge.curve, turned, boundary.resolution);
                edge.onFaces.at(use.side()) = found.curve;
                raiseTolerance(boundary, use.edge, toleranceOf(found.gap, boundary.resolution));
            }
    }

private:
    [[nodiscard]] SimpleSurface surfaceOf(std::size_t face) const {
        return {Handle(Geom_ElementarySurface)::DownCast(boundary_.faces[face].surface),
                boundary_.faces[face].reversed};
    }

    [[nodiscard]] const Handle(Geom2d_BSplineCurve) & curveOf(const EdgeUse& use) const {
        return boundary_.edges[use.edge].onFaces.at(use.side());
    }

    /// Vertices of a face, each with its angle on the face's own surface.
    [[nodiscard]] std::vector<std::pair<std::size_t, double>> anglesAt(std::size_t face) const {
        std::vector<std::pair<std::size_t, double>> result;
        for (const EdgeUse& use : boundary_.faces[face].loops.front()) {
            const auto& edge = boundary_.edges[use.edge];
            result.emplace_back(edge.ends[0], curveOf(use)->StartPoint().X());
            result.emplace_back(edge.ends[1], curveOf(use)->EndPoint().X());
        }
        return result;
    }

    /// Takes a face in, unless all together would go around too far.
    bool take(std::size_t face, double shift) {
        double minAngle = minAngle_, maxAngle = maxAngle_;
        for (const EdgeUse& use : boundary_.faces[face].loops.front())
            for (const gp_Pnt2d& point : curveOf(use)->Poles()) {
                minAngle = std::min(minAngle, point.X() + shift);
                maxAngle = std::max(maxAngle, point.X() + shift);
            }
        if (maxAngle - minAngle > maxTurn_ && !angleAt_.empty()) {
            goesAround_ = true;
            return false;
        }
        minAngle_ = minAngle;
        maxAngle_ = maxAngle;
        for (const auto& [vertex, angle] : anglesAt(face))
            angleAt_.emplace(vertex, angle + shift);
        return true;
    }

    const Boundary& boundary_;
    SimpleSurface surface_;
    bool reversed_;
    double maxTurn_;
    bool goesAround_ = false;
    std::map<std::size_t, double> angleAt_; ///< by vertex
    double minAngle_ = infinity;
    double maxAngle_ = -infinity;
};

} // namespace

std::unique_ptr<FaceChart> ruledChart(const Boundary& boundary, std::size_t face, double maxTurn) {
    const SimpleSurface surface{Handle(Geom_ElementarySurface)::DownCast(boundary.faces[face].surface)};
    if (surface.surface.IsNull() || !areOneRuledSurface(surface, surface, boundary.resolution))
        return nullptr;
    return std::make_unique<RuledChart>(boundary, face, maxTurn);
}

} // namespace qm
