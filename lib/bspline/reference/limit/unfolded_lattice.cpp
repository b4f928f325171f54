#include "bspline/reference/limit/unfolded_lattice.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/reference/bending/edge_curves.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/splines/eigen_point.h"
#include "bspline/splines/spline_curve.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// Smallest cosine of the angle between the surface and a quad, or between a curve and an edge: 60 degrees.
constexpr double minCosine = 0.5;
/// Smallest area over a part of a quad, as a share of the part's own: with less, it is easily turned over.
constexpr double minArea = 0.3;
constexpr double minAreaAtPoint = 0.1;
/// Largest number of passes over the mesh. Real folds take two; those that spread farther are left.
constexpr int maxPasses = 8;

class Unfolding {
public:
    Unfolding(MeshLattice& lattice, const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
              unsigned jobs)
        : lattice_(lattice), numbers_(lattice.numbers()), mesh_(numbers_.mesh()), squares_(lattice.squares()),
          rules_(rules), sharp_(sharp), jobs_(jobs), isSound_(soundFaces(mesh_, jobs)),
          isFolded_(mesh_.n_faces()), isRedrawn_(mesh_.n_edges()) {
        for (int k = 0; k <= squares_; ++k)
            weights_.push_back(lagrange(squares_, share(k)));
    }

    void run() {
        if (!findFolds()) return;
        const MeshLattice before = lattice_;
        const EdgeCurves curves(before, rules_, sharp_);
        for (int pass = 0; pass < maxPasses; ++pass) {
            for (const EdgeId edge : mesh_.edges()) {
                if (isRedrawn_[at(edge)] || !liesBesideFold(edge)) continue;
                isRedrawn_[at(edge)] = !sharp_[at(edge)] || turnsBack(edge);
                if (isRedrawn_[at(edge)]) draw(mesh_.halfedge_handle(edge, 0), curves);
            }
            parallelForMany(mesh_.n_faces(), jobs_,
                            [&](std::size_t face) { fill(FaceId(static_cast<int>(face)), before); });
            if (!findFolds()) return;
        }
    }

private:
    [[nodiscard]] double share(int k) const { return static_cast<double>(k) / squares_; }

    /// In column i and row j of a face.
    [[nodiscard]] Point point(FaceId face, int i, int j) const {
        return lattice_.point(numbers_(face, i, j));
    }

    /// Faces that were drawn along with their neighbours may fold for that reason.
    /// \return whether there are new ones
    bool findFolds() {
        std::atomic<bool> isNew = false;
        parallelForMany(mesh_.n_faces(), jobs_, [&](std::size_t face) {
            if (isFolded_[face] || !isSound_[face] || !folds(FaceId(static_cast<int>(face)))) return;
            isFolded_[face] = true;
            isNew = true;
        });
        return isNew;
    }

    void fill(FaceId face, const MeshLattice& before) {
        if (isFolded_[at(face)])
            fill(face, [&, quad = quadBetween(face)](int i, int j) {
                return quad.evaluate(share(i), share(j)).position;
            });
        else if (std::ranges::any_of(mesh_.fe_range(face), [&](EdgeId edge) { return isRedrawn_[at(edge)]; }))
            fill(face, [&](int i, int j) { return before.point(numbers_(face, i, j)); });
    }

    [[nodiscard]] BilinearQuad quadBetween(FaceId face) const {
        return BilinearQuad({point(face, 0, 0), point(face, squares_, 0), point(face, squares_, squares_),
                             point(face, 0, squares_)});
    }

    /// Some square of the lattice is turned over, or nearly so, or has hardly any area left; or the surface
    /// does so at one of the lattice's points.
    [[nodiscard]] bool folds(FaceId face) const {
        const BilinearQuad quad = quadBetween(face);
        if (foldsAtPoint(face, quad)) return true;
        for (int j = 0; j < squares_; ++j)
            for (int i = 0; i < squares_; ++i) {
                const Point turn = (point(face, i + 1, j + 1) - point(face, i, j)) %
                                   (point(face, i, j + 1) - point(face, i + 1, j)) / 2;
                const SurfacePoint even = quad.evaluate(share(i) + share(1) / 2, share(j) + share(1) / 2);
                const double area = (even.du % even.dv).norm() * share(1) * share(1);
                const double upright = turn | quad.normal();
                if (!(upright >= minCosine * turn.norm() && upright >= minArea * area)) return true;
            }
        return false;
    }

    [[nodiscard]] bool foldsAtPoint(FaceId face, const BilinearQuad& quad) const {
        const std::vector<Eigen::Vector3d> points = lattice_.points(face);
        const auto width = at(squares_) + 1;
        for (std::size_t j = 0; j < width; ++j)
            for (std::size_t i = 0; i < width; ++i) {
                Eigen::Vector3d du(0, 0, 0), dv(0, 0, 0);
                for (std::size_t k = 0; k < width; ++k) {
                    du += weights_[i][k][1] * points[j * width + k];
                    dv += weights_[j][k][1] * points[k * width + i];
                }
                const SurfacePoint even =
                    quad.evaluate(share(static_cast<int>(i)), share(static_cast<int>(j)));
                const double upright = du.cross(dv).dot(vector(quad.normal()));
                if (!(upright >= minAreaAtPoint * (even.du % even.dv).norm())) return true;
            }
        return false;
    }

    /// All its faces are sound, and over one the surface folds.
    [[nodiscard]] bool liesBesideFold(EdgeId edge) const {
        bool folds = false;
        for (const unsigned side : {0U, 1U}) {
            const FaceId face = mesh_.face_handle(mesh_.halfedge_handle(edge, side));
            if (!face.is_valid()) continue; // beyond the boundary
            if (!isSound_[at(face)]) return false;
            folds = folds || isFolded_[at(face)];
        }
        return folds;
    }

    /// The curve above an edge somewhere goes back, or nearly so.
    [[nodiscard]] bool turnsBack(EdgeId edge) const {
        const auto point = [&](int k) {
            return lattice_.point(numbers_(mesh_.halfedge_handle(edge, 0), k, 0));
        };
        const Point chord = unit(point(squares_) - point(0));
        for (int k = 0; k < squares_; ++k) {
            const Point step = point(k + 1) - point(k);
            if (!((step | chord) >= minCosine * step.norm())) return true;
        }
        return false;
    }

    void draw(HalfedgeId halfedge, const EdgeCurves& curves) {
        const SplineCurve curve = bezier(curves.above(halfedge), 1);
        for (int k = 1; k < squares_; ++k)
            lattice_.move(numbers_(halfedge, k, 0), evaluate(curve, share(k)));
    }

    /// Puts the inner points where a form has them, moved as the form's border is to be moved to get to the
    /// face's; the corners are the same (docs/METHOD.md#coons-1967).
    template <class Form> void fill(FaceId face, const Form& form) {
        const auto missing = [&](int i, int j) { return point(face, i, j) - form(i, j); };
        for (int j = 1; j < squares_; ++j)
            for (int i = 1; i < squares_; ++i) {
                const double s = share(i), t = share(j);
                lattice_.move(numbers_(face, i, j), form(i, j) + (1 - t) * missing(i, 0) +
                                                        t * missing(i, squares_) + (1 - s) * missing(0, j) +
                                                        s * missing(squares_, j));
            }
    }

    MeshLattice& lattice_;
    const LatticeNumbers& numbers_;
    const QuadMesh& mesh_;
    int squares_;
    const std::vector<VertexRule>& rules_;
    const std::vector<bool>& sharp_;
    unsigned jobs_;
    std::vector<LagrangeWeights> weights_; ///< at the lattice's parameters
    std::vector<bool> isSound_;            ///< by face
    std::vector<char> isFolded_;           ///< by face; bytes, as threads write them
    std::vector<bool> isRedrawn_;          ///< by edge
};

} // namespace

void unfold(MeshLattice& lattice, const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
            unsigned jobs) {
    Unfolding(lattice, rules, sharp, jobs).run();
}

} // namespace qm
