#include "bspline/line_derivatives.h"

#include "bspline/evaluate.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

/// A common derivative of both sides would overshoot on the side with the shorter step.
bool isUneven(const Point& step, const Point& stepBack) {
    constexpr double ratio = 2;
    const double a = step.sqrnorm();
    const double b = stepBack.sqrnorm();
    return std::max(a, b) > ratio * ratio * std::min(a, b);
}

/// The direction, at the middle one of three points, of the parabola through them by chord length; as long as
/// the step on the own side. The other side gets the opposite direction.
Point alongParabola(const Point& step, const Point& stepBack) {
    const double length = step.norm();
    const double lengthBack = stepBack.norm();
    if (!(length > 0 && lengthBack > 0)) return step;
    const Point direction = lengthBack / length * step - length / lengthBack * stepBack;
    const double size = direction.norm();
    return size > 0 ? Point(direction * (length / size)) : step;
}

/// The refined estimate, unless steps of very different length have spoilt it.
Point unlessSpoilt(const Point& refined, const Point& plain) {
    return (refined | plain) > 0.5 * plain.sqrnorm() ? refined : plain;
}

} // namespace

LineDerivatives::LineDerivatives(const QuadMesh& mesh, const std::vector<double>& dihedralAngles, double rho)
    : mesh_(mesh), smooth_(dihedralAngles.size()), rho_(rho) {
    for (std::size_t k = 0; k < smooth_.size(); ++k)
        smooth_[k] = dihedralAngles[k] <= rho;
}

bool LineDerivatives::isSmooth(EdgeId edge) const {
    return smooth_[static_cast<std::size_t>(edge.idx())];
}

const Point& LineDerivatives::end(HalfedgeId halfedge) const {
    return mesh_.point(mesh_.to_vertex_handle(halfedge));
}

const Point& LineDerivatives::start(HalfedgeId halfedge) const {
    return mesh_.point(mesh_.from_vertex_handle(halfedge));
}

HalfedgeId LineDerivatives::opposite(HalfedgeId halfedge) const {
    return mesh_.opposite_halfedge_handle(halfedge);
}

/// The line's next halfedge, if it passes the vertex that this one points to.
std::optional<HalfedgeId> LineDerivatives::goOn(HalfedgeId halfedge) const {
    const VertexId vertex = mesh_.to_vertex_handle(halfedge);
    if (!isRegular(mesh_, vertex)) return std::nullopt;
    const auto smooth = [&](HalfedgeId h) { return isSmooth(mesh_.edge_handle(h)); };
    if (!mesh_.is_boundary(vertex)) {
        const HalfedgeId left = mesh_.next_halfedge_handle(halfedge);
        const HalfedgeId right = mesh_.prev_halfedge_handle(opposite(halfedge));
        if (!smooth(left) || !smooth(right)) return std::nullopt;
        return straightOn(mesh_, halfedge);
    }
    // Along the boundary: past one edge that leads inwards.
    HalfedgeId on;
    HalfedgeId inwards;
    if (mesh_.is_boundary(halfedge)) {
        on = mesh_.next_halfedge_handle(halfedge);
        inwards = mesh_.prev_halfedge_handle(opposite(halfedge));
    } else if (mesh_.is_boundary(opposite(halfedge))) {
        on = opposite(mesh_.prev_halfedge_handle(opposite(halfedge)));
        inwards = mesh_.next_halfedge_handle(halfedge);
    } else {
        return std::nullopt;
    }
    if (mesh_.is_boundary(mesh_.edge_handle(inwards)) || !smooth(inwards)) return std::nullopt;
    const Point before = end(halfedge) - start(halfedge);
    const Point after = end(on) - start(on);
    if (std::atan2((before % after).norm(), before | after) > rho_) return std::nullopt;
    return on;
}

Point LineDerivatives::tangent(HalfedgeId halfedge) const {
    const auto back = goOn(opposite(halfedge));
    const Point ownSide = oneSided(halfedge);
    if (!back || bendsSharply(halfedge, ownSide, oneSided(*back))) return inTangentPlane(halfedge, ownSide);
    const Point step = end(halfedge) - start(halfedge);
    const Point stepBack = end(*back) - start(*back);
    if (isUneven(step, stepBack)) return alongParabola(step, stepBack);
    const Point chord = step - stepBack;
    const auto further = goOn(halfedge);
    const auto furtherBack = goOn(*back);
    if (!further || !furtherBack) return chord / 2.0;
    return unlessSpoilt((8.0 * chord - (end(*further) - end(*furtherBack))) / 12.0, chord / 2.0);
}

Point LineDerivatives::oneSided(HalfedgeId halfedge) const {
    const Point step = end(halfedge) - start(halfedge);
    const auto further = goOn(halfedge);
    return further ? unlessSpoilt(1.5 * step - 0.5 * (end(*further) - end(halfedge)), step) : step;
}

/// Near extraordinary vertices lines bend. A derivative between the directions of both sides would fold a
/// surface whose rows lie closer together than the two differ.
bool LineDerivatives::bendsSharply(HalfedgeId halfedge, const Point& forwards, const Point& backwards) const {
    double spacing = std::numeric_limits<double>::infinity();
    if (!mesh_.is_boundary(halfedge)) {
        const HalfedgeId left = mesh_.prev_halfedge_handle(halfedge);
        spacing = (end(left) - start(left)).sqrnorm();
    }
    if (!mesh_.is_boundary(opposite(halfedge))) {
        const HalfedgeId right = mesh_.next_halfedge_handle(opposite(halfedge));
        spacing = std::min(spacing, (end(right) - start(right)).sqrnorm());
    }
    return (forwards + backwards).sqrnorm() > spacing;
}

/// Patches that meet at a vertex have one normal there if all tangents of a smooth sector lie in one plane.
/// An edge between two sectors lies in both planes.
Point LineDerivatives::inTangentPlane(HalfedgeId halfedge, const Point& tangent) const {
    const Point left = normalOnLeft(halfedge);
    const Point right = isSmooth(mesh_.edge_handle(halfedge))
                            ? left
                            : normalOnLeft(mesh_.next_halfedge_handle(opposite(halfedge)));
    const Point ridge = left % right;
    const Point normal = left.sqrnorm() > 0 ? left : right;
    Point turned = tangent - (tangent | normal) * normal;
    if (ridge.norm() > std::sin(rho_ / 2)) turned = (tangent | ridge) / ridge.sqrnorm() * ridge;
    return unlessSpoilt(turned, tangent);
}

Point LineDerivatives::normalOnLeft(HalfedgeId halfedge) const {
    // Back, clockwise, to where the sector begins; then count its faces.
    const auto onLeft = [&](HalfedgeId h) { return opposite(mesh_.prev_halfedge_handle(h)); };
    HalfedgeId first = halfedge;
    while (isSmooth(mesh_.edge_handle(first)) && !mesh_.is_boundary(opposite(first))) {
        first = mesh_.next_halfedge_handle(opposite(first));
        if (first == halfedge) break;
    }
    Point sum{0, 0, 0};
    for (HalfedgeId h = first; !mesh_.is_boundary(h);) {
        const HalfedgeId left = onLeft(h);
        sum += unitNormal(end(h) - start(h), end(left) - start(left));
        h = left;
        if (h == first || !isSmooth(mesh_.edge_handle(h))) break;
    }
    const double length = sum.norm();
    return length > 1e-6 ? Point(sum / length) : Point(0, 0, 0);
}

/// The mean over the faces around the vertex into which either line goes on.
Point LineDerivatives::twist(HalfedgeId halfedge) const {
    const auto onLeft = [&](HalfedgeId h) { return opposite(mesh_.prev_halfedge_handle(h)); };
    const auto ofFace = [&](HalfedgeId h) -> Point {
        return end(mesh_.next_halfedge_handle(h)) - end(h) - end(onLeft(h)) + start(h);
    };
    const HalfedgeId left = onLeft(halfedge);
    const bool passes = goOn(opposite(halfedge)).has_value();
    const bool leftPasses = goOn(opposite(left)).has_value();
    Point sum = ofFace(halfedge);
    if (passes) sum -= ofFace(left);
    if (leftPasses) sum -= ofFace(mesh_.next_halfedge_handle(opposite(halfedge)));
    if (passes && leftPasses) sum += ofFace(onLeft(left));
    return sum / ((passes ? 2.0 : 1.0) * (leftPasses ? 2.0 : 1.0));
}

} // namespace qm
