#include "bspline/reference/planes/plane_growth.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/planes/principal_axes.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/parallel_elements.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace qm {
namespace {

constexpr int none = PlaneParts::none;
/// Cosine of the angle between a plane and its quads: small ones may be tilted by roundings of vertices.
constexpr double upright = 0.9;

/// Where more than this share of the faces that a part grows over, and some more, have been tried before, it
/// is given up: it would turn out too thick, as what was tried there did, and on fine meshes that bend slowly
/// everything would be grown over again and again.
struct Overlap {
    static constexpr double share = 0.5;
    static constexpr double some = 100;
};

class PlaneGrowth {
public:
    PlaneGrowth(const QuadMesh& mesh, const std::vector<bool>& isCrease, const std::vector<FlatQuad>& quads,
                double flatness, unsigned jobs)
        : mesh_(mesh), isCrease_(isCrease), quads_(quads), flatness_(flatness), jobs_(jobs),
          visit_(mesh.n_faces()), isTried_(mesh.n_faces()) {
        parts_.ofFace.resize(mesh.n_faces(), none);
    }

    PlaneParts run() {
        for (const FaceId face : seeds())
            if (!isTried_[at(face)]) growFrom(face);
        return std::move(parts_);
    }

private:
    /// Plane quads. Those around which the mesh is flattest come first: from beside a plane, a part would
    /// grow into it and turn away from where it began.
    [[nodiscard]] std::vector<FaceId> seeds() const {
        constexpr double notPlane = infinity;
        std::vector<double> rises(mesh_.n_faces());
        parallelForFaces(mesh_, jobs_, [&](FaceId face) {
            const Spread spread = spreadOf({face});
            rises[at(face)] = isIn(spread.plane, spread) ? riseAround(face) : notPlane;
        });
        std::vector<FaceId> result;
        result.reserve(mesh_.n_faces());
        std::ranges::copy_if(mesh_.faces(), std::back_inserter(result),
                             [&](FaceId face) { return rises[at(face)] < notPlane; });
        std::ranges::stable_sort(result, {}, [&](FaceId face) { return rises[at(face)]; });
        return result;
    }

    /// How far the faces beside one rise from its plane or fall below; 0 if that is negligible.
    [[nodiscard]] double riseAround(FaceId face) const {
        constexpr double negligible = 1e-3; // relative to the flatness
        double max = 0;
        for (const HalfedgeId side : mesh_.fh_range(face)) {
            if (isCrease_[at(mesh_.edge_handle(side))]) continue;
            const HalfedgeId beside = mesh_.opposite_halfedge_handle(side);
            for (const HalfedgeId away :
                 {mesh_.next_halfedge_handle(beside), mesh_.prev_halfedge_handle(beside)})
                max = std::max(max, std::abs(mesh_.calc_edge_vector(away) | quads_[at(face)].normal));
        }
        return max < negligible * flatness_ ? 0 : max;
    }

    /// The corners of faces, and the plane nearest to them.
    struct Spread {
        std::vector<Eigen::Vector3d> points;
        Plane plane;
        double allowed = 0; ///< distance of a part's points from its plane
    };

    struct Part {
        std::vector<FaceId> faces;
        Plane plane;
    };

    struct Growth {
        std::vector<FaceId> faces;
        bool isGivenUp = false; ///< see `Overlap`; then not all faces are there
    };

    /// A plane through few vertices may be tilted by their roundings, so it is found again as the part grows,
    /// until it turns away from the seed.
    void growFrom(FaceId seed) {
        std::vector<FaceId> faces{seed};
        Spread spread = spreadOf(faces);
        Part largest;
        for (std::size_t before = 0; faces.size() > before && liesIn(spread.plane, seed);) {
            before = faces.size();
            const Plane grownBy = spread.plane;
            Growth growth = grown(seed, grownBy);
            faces = std::move(growth.faces);
            if (growth.isGivenUp) break;
            spread = spreadOf(faces);
            for (const Plane& plane : {spread.plane, grownBy}) {
                if (faces.size() < largest.faces.size() || !isIn(plane, spread)) continue;
                largest = {faces, plane};
                break;
            }
        }
        for (const FaceId face : faces)
            isTried_[at(face)] = true;
        for (const FaceId face : largest.faces) {
            isTried_[at(face)] = true;
            parts_.ofFace[at(face)] = static_cast<int>(parts_.planes.size());
        }
        if (!largest.faces.empty()) parts_.planes.push_back(largest.plane);
    }

    /// The seed, and the faces that lie in the plane and are connected with it.
    [[nodiscard]] Growth grown(FaceId seed, const Plane& plane) {
        ++visits_;
        Growth growth{{seed}};
        std::vector<FaceId>& faces = growth.faces;
        visit_[at(seed)] = visits_;
        double tried = 0;
        for (std::size_t k = 0; k < faces.size() && !growth.isGivenUp; ++k) {
            tried += isTried_[at(faces[k])] ? 1 : 0;
            growth.isGivenUp = tried > Overlap::some + Overlap::share * static_cast<double>(k);
            for (const HalfedgeId side : mesh_.fh_range(faces[k])) {
                if (isCrease_[at(mesh_.edge_handle(side))]) continue;
                const FaceId beside = mesh_.opposite_face_handle(side);
                if (visit_[at(beside)] == visits_ || !liesIn(plane, beside)) continue;
                visit_[at(beside)] = visits_;
                faces.push_back(beside);
            }
        }
        return growth;
    }

    [[nodiscard]] bool liesIn(const Plane& plane, FaceId face) const {
        return parts_.ofFace[at(face)] == none && (quads_[at(face)].normal | plane.normal) > upright &&
               std::ranges::all_of(mesh_.fv_range(face), [&](VertexId corner) {
                   return std::abs(plane.distance(mesh_.point(corner))) <= flatness_;
               });
    }

    [[nodiscard]] Spread spreadOf(const std::vector<FaceId>& faces) const {
        Spread spread;
        spread.points.reserve(4 * faces.size());
        for (const FaceId face : faces)
            for (const VertexId corner : mesh_.fv_range(face))
                spread.points.push_back(vector(mesh_.point(corner)));
        const PrincipalAxes axes = principalAxes(spread.points);
        Eigen::Vector3d normal = axes.axes.col(0);
        const double side = normal.dot(vector(quads_[at(faces.front())].normal));
        if (side < 0) normal = -normal;
        spread.plane = {point(normal), normal.dot(axes.middle)};
        if (side != 0) spread.allowed = std::min(flatness_, maxThickness * axes.extents[1]);
        return spread;
    }

    [[nodiscard]] static bool isIn(const Plane& plane, const Spread& spread) {
        return spread.allowed > 0 && std::ranges::all_of(spread.points, [&](const Eigen::Vector3d& at) {
                   return std::abs(plane.distance(point(at))) <= spread.allowed;
               });
    }

    const QuadMesh& mesh_;
    const std::vector<bool>& isCrease_;
    const std::vector<FlatQuad>& quads_;
    double flatness_;
    unsigned jobs_;
    std::vector<int> visit_; ///< by face: the last growth that came there
    int visits_ = 0;
    std::vector<bool> isTried_; ///< by face: growth came there
    PlaneParts parts_;
};

} // namespace

PlaneParts grownPlaneParts(const QuadMesh& mesh, const std::vector<bool>& isCrease,
                           const std::vector<FlatQuad>& quads, double flatness, unsigned jobs) {
    return PlaneGrowth(mesh, isCrease, quads, flatness, jobs).run();
}

} // namespace qm
