#include "bspline/reference/planes/plane_growth.h"

#include "base/at.h"
#include "bspline/reference/planes/principal_axes.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace qm {
namespace {

constexpr int none = PlaneParts::none;
/// Cosine of the angle between a plane and its quads: small ones may be tilted by roundings of vertices.
constexpr double upright = 0.9;

class PlaneGrowth {
public:
    PlaneGrowth(const QuadMesh& mesh, const std::vector<bool>& isCrease, const std::vector<FlatQuad>& quads,
                double flatness)
        : mesh_(mesh), isCrease_(isCrease), quads_(quads), flatness_(flatness), visit_(mesh.n_faces()),
          isTried_(mesh.n_faces()) {
        parts_.ofFace.resize(mesh.n_faces(), none);
    }

    PlaneParts run() {
        for (const FaceId face : mesh_.faces())
            if (!isTried_[at(face)]) growFrom(face);
        return std::move(parts_);
    }

private:
    struct Fit {
        Plane plane;
        bool isPlane = false;
    };

    /// A plane through few vertices may be tilted by their roundings, so it is found again as the part grows.
    void growFrom(FaceId seed) {
        std::vector<FaceId> faces{seed};
        Fit fit = fitted(faces);
        if (!fit.isPlane) return;
        for (std::size_t before = 0; faces.size() > before;) {
            before = faces.size();
            faces = grown(seed, fit.plane);
            fit = fitted(faces);
        }
        for (const FaceId face : faces)
            isTried_[at(face)] = true;
        if (!fit.isPlane) return;
        for (const FaceId face : faces)
            parts_.ofFace[at(face)] = static_cast<int>(parts_.planes.size());
        parts_.planes.push_back(fit.plane);
    }

    /// The seed, and the faces that lie in the plane and are connected with it.
    [[nodiscard]] std::vector<FaceId> grown(FaceId seed, const Plane& plane) {
        ++visits_;
        std::vector<FaceId> faces{seed};
        visit_[at(seed)] = visits_;
        for (std::size_t k = 0; k < faces.size(); ++k)
            for (const HalfedgeId side : mesh_.fh_range(faces[k])) {
                if (isCrease_[at(mesh_.edge_handle(side))]) continue;
                const FaceId beside = mesh_.opposite_face_handle(side);
                if (visit_[at(beside)] == visits_ || !liesIn(plane, beside)) continue;
                visit_[at(beside)] = visits_;
                faces.push_back(beside);
            }
        return faces;
    }

    [[nodiscard]] bool liesIn(const Plane& plane, FaceId face) const {
        return parts_.ofFace[at(face)] == none && (quads_[at(face)].normal | plane.normal) > upright &&
               std::ranges::all_of(mesh_.fv_range(face), [&](VertexId corner) {
                   return std::abs(plane.distance(mesh_.point(corner))) <= flatness_;
               });
    }

    [[nodiscard]] Fit fitted(const std::vector<FaceId>& faces) const {
        std::vector<Eigen::Vector3d> points;
        points.reserve(4 * faces.size());
        for (const FaceId face : faces)
            for (const VertexId corner : mesh_.fv_range(face))
                points.push_back(vector(mesh_.point(corner)));
        const PrincipalAxes spread = principalAxes(points);
        Eigen::Vector3d normal = spread.axes.col(0);
        const double side = normal.dot(vector(quads_[at(faces.front())].normal));
        if (side < 0) normal = -normal;
        Fit fit{{point(normal), normal.dot(spread.middle)}};
        const double allowed = std::min(flatness_, maxThickness * spread.extents[1]);
        fit.isPlane = side != 0 && std::ranges::all_of(points, [&](const Eigen::Vector3d& at) {
                          return std::abs(fit.plane.distance(point(at))) <= allowed;
                      });
        return fit;
    }

    const QuadMesh& mesh_;
    const std::vector<bool>& isCrease_;
    const std::vector<FlatQuad>& quads_;
    double flatness_;
    std::vector<int> visit_; ///< by face: the last growth that came there
    int visits_ = 0;
    std::vector<bool> isTried_; ///< by face: a part has grown over it
    PlaneParts parts_;
};

} // namespace

PlaneParts grownPlaneParts(const QuadMesh& mesh, const std::vector<bool>& isCrease,
                           const std::vector<FlatQuad>& quads, double flatness) {
    return PlaneGrowth(mesh, isCrease, quads, flatness).run();
}

} // namespace qm
