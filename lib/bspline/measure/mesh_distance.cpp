#include "bspline/measure/mesh_distance.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace qm {
namespace {

namespace index = boost::geometry::index;
using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<TreePoint>;
using Entry = std::pair<Box, std::uint32_t>;

TreePoint treePoint(const Point& point) {
    return {point[0], point[1], point[2]};
}

double squaredDistanceToEdge(const Point& a, const Point& b, const Point& point) {
    const Point along = b - a;
    const double length = along.sqrnorm();
    const double t = length > 0 ? std::clamp(((point - a) | along) / length, 0.0, 1.0) : 0;
    return (a + t * along - point).sqrnorm();
}

/// Squared distance at the critical point that Newton's iteration reaches, or infinity if it leaves the quad.
double squaredDistanceInside(const QuadCorners& corners, const Point& point) {
    const Point alongS = corners[1] - corners[0];
    const Point alongT = corners[3] - corners[0];
    const Point twist = corners[2] - corners[1] - alongT;
    double s = 0.5;
    double t = 0.5;
    for (int k = 0; k < 8; ++k) {
        const Point ds = alongS + t * twist;
        const Point dt = alongT + s * twist;
        const Point away = corners[0] + s * alongS + t * dt - point;
        const double gs = away | ds;
        const double gt = away | dt;
        const double ss = ds.sqrnorm();
        const double tt = dt.sqrnorm();
        const double st = (ds | dt) + (away | twist);
        const double determinant = ss * tt - st * st;
        if (!(determinant > 0)) break;
        const double stepS = (st * gt - tt * gs) / determinant;
        const double stepT = (st * gs - ss * gt) / determinant;
        s += stepS;
        t += stepT;
        if (s < -1 || s > 2 || t < -1 || t > 2) break;
        if (std::abs(stepS) + std::abs(stepT) < 1e-9) break;
    }
    if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::numeric_limits<double>::infinity();
    return (bilinear(corners, s, t) - point).sqrnorm();
}

double squaredDistanceToQuad(const QuadCorners& corners, const Point& point) {
    double best = squaredDistanceInside(corners, point);
    for (std::size_t k = 0; k < 4; ++k)
        best = std::min(best, squaredDistanceToEdge(corners[k], corners[(k + 1) % 4], point));
    return best;
}

} // namespace

Point bilinear(const QuadCorners& corners, double s, double t) {
    return (1 - t) * ((1 - s) * corners[0] + s * corners[1]) + t * ((1 - s) * corners[3] + s * corners[2]);
}

double distanceToQuad(const QuadCorners& corners, const Point& point) {
    return std::sqrt(squaredDistanceToQuad(corners, point));
}

struct MeshDistance::Tree {
    std::vector<QuadCorners> quads;
    index::rtree<Entry, index::rstar<8>> boxes;
};

MeshDistance::MeshDistance(const QuadMesh& mesh) : tree_(std::make_unique<Tree>()) {
    std::vector<Entry> entries;
    entries.reserve(mesh.n_faces());
    tree_->quads.reserve(mesh.n_faces());
    for (const FaceId face : mesh.faces()) {
        QuadCorners corners;
        auto corner = corners.begin();
        for (const VertexId vertex : mesh.fv_range(face))
            *corner++ = mesh.point(vertex);
        Point low = corners[0];
        Point high = corners[0];
        for (const Point& point : corners) {
            low.minimize(point);
            high.maximize(point);
        }
        entries.emplace_back(Box(treePoint(low), treePoint(high)),
                             static_cast<std::uint32_t>(tree_->quads.size()));
        tree_->quads.push_back(corners);
    }
    tree_->boxes = index::rtree<Entry, index::rstar<8>>(entries);
}

MeshDistance::~MeshDistance() = default;
MeshDistance::MeshDistance(MeshDistance&&) noexcept = default;
MeshDistance& MeshDistance::operator=(MeshDistance&&) noexcept = default;

double MeshDistance::operator()(const Point& point, double bound) const {
    // A quad nearer than the bound has a box that meets the cube around the point.
    const Point reach(bound, bound, bound);
    const Box cube(treePoint(point - reach), treePoint(point + reach));
    double best = bound * bound;
    const auto consider = [&](const Entry& entry) {
        if (boost::geometry::comparable_distance(treePoint(point), entry.first) < best)
            best = std::min(best, squaredDistanceToQuad(tree_->quads[entry.second], point));
    };
    tree_->boxes.query(index::intersects(cube), boost::make_function_output_iterator(consider));
    return std::sqrt(best);
}

} // namespace qm
