#include "bspline/reference/unfolded_lattice.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/reference/sound_faces.h"

#include <algorithm>
#include <cstddef>

namespace qm {
namespace {

class Unfolding {
public:
    Unfolding(MeshLattice& lattice, const std::vector<bool>& sharp)
        : lattice_(lattice), numbers_(lattice.numbers()), mesh_(numbers_.mesh()), squares_(lattice.squares()),
          sharp_(sharp), isSound_(soundFaces(mesh_)), isFolded_(mesh_.n_faces()) {}

    void run(unsigned jobs) {
        parallelForMany(mesh_.n_faces(), jobs, [&](std::size_t face) {
            const FaceId handle(static_cast<int>(face));
            isFolded_[face] = isSound_[face] && folds(handle) && liesInPlane(handle);
        });
        if (std::ranges::none_of(isFolded_, [](char folded) { return folded != 0; })) return;
        const MeshLattice before = lattice_;
        for (const EdgeId edge : mesh_.edges())
            if (becomesStraight(edge)) straighten(mesh_.halfedge_handle(edge, 0));
        parallelForMany(mesh_.n_faces(), jobs, [&](std::size_t face) {
            const FaceId handle(static_cast<int>(face));
            if (isFolded_[face])
                fill(handle, [&, quad = quadBetween(handle)](int i, int j) {
                    return quad.evaluate(share(i), share(j)).position;
                });
            else if (std::ranges::any_of(mesh_.fe_range(handle),
                                         [&](EdgeId e) { return becomesStraight(e); }))
                fill(handle, [&](int i, int j) { return before.point(number(handle, i, j)); });
        });
    }

private:
    [[nodiscard]] double share(int k) const { return static_cast<double>(k) / squares_; }

    /// Of the lattice point in column i and row j of a face.
    [[nodiscard]] std::size_t number(FaceId face, int i, int j) const {
        return numbers_(mesh_.halfedge_handle(face), i, j);
    }
    [[nodiscard]] Point point(FaceId face, int i, int j) const { return lattice_.point(number(face, i, j)); }

    [[nodiscard]] BilinearQuad quadBetween(FaceId face) const {
        return BilinearQuad({point(face, 0, 0), point(face, squares_, 0), point(face, squares_, squares_),
                             point(face, 0, squares_)});
    }

    /// Some square of the lattice is turned over.
    [[nodiscard]] bool folds(FaceId face) const {
        const Point normal = quadBetween(face).normal();
        for (int j = 0; j < squares_; ++j)
            for (int i = 0; i < squares_; ++i) {
                const Point turn = (point(face, i + 1, j + 1) - point(face, i, j)) %
                                   (point(face, i, j + 1) - point(face, i + 1, j));
                if (!((turn | normal) >= uprightCosine * turn.norm())) return true;
            }
        return false;
    }

    /// What it meets smoothly is in one plane with it, so that the quad does so, too.
    [[nodiscard]] bool liesInPlane(FaceId face) const {
        constexpr double same = 0.985; // cosine of 10 degrees
        const Point normal = quadBetween(face).normal();
        return std::ranges::all_of(mesh_.fh_range(face), [&](HalfedgeId halfedge) {
            if (sharp_[at(mesh_.edge_handle(halfedge))]) return true;
            return (quadBetween(mesh_.opposite_face_handle(halfedge)).normal() | normal) > same;
        });
    }

    [[nodiscard]] bool becomesStraight(EdgeId edge) const {
        if (sharp_[at(edge)]) return false;
        const FaceId one = mesh_.face_handle(mesh_.halfedge_handle(edge, 0));
        const FaceId other = mesh_.face_handle(mesh_.halfedge_handle(edge, 1));
        return isSound_[at(one)] && isSound_[at(other)] && (isFolded_[at(one)] || isFolded_[at(other)]);
    }

    void straighten(HalfedgeId halfedge) {
        const Point from = lattice_.point(numbers_(halfedge, 0, 0));
        const Point to = lattice_.point(numbers_(halfedge, squares_, 0));
        for (int k = 1; k < squares_; ++k)
            lattice_.move(numbers_(halfedge, k, 0), from + share(k) * (to - from));
    }

    /// Puts the inner points where a form has them, moved as the form's border is to be moved to get to the
    /// face's; the corners are the same (docs/METHOD.md#coons-1967).
    template <class Form> void fill(FaceId face, const Form& form) {
        const auto missing = [&](int i, int j) { return point(face, i, j) - form(i, j); };
        for (int j = 1; j < squares_; ++j)
            for (int i = 1; i < squares_; ++i) {
                const double s = share(i), t = share(j);
                lattice_.move(number(face, i, j), form(i, j) + (1 - t) * missing(i, 0) +
                                                      t * missing(i, squares_) + (1 - s) * missing(0, j) +
                                                      s * missing(squares_, j));
            }
    }

    MeshLattice& lattice_;
    const LatticeNumbers& numbers_;
    const QuadMesh& mesh_;
    int squares_;
    const std::vector<bool>& sharp_;
    std::vector<bool> isSound_;  ///< by face
    std::vector<char> isFolded_; ///< by face; bytes, as threads write them
};

} // namespace

void unfold(MeshLattice& lattice, const std::vector<bool>& sharp, unsigned jobs) {
    Unfolding(lattice, sharp).run(jobs);
}

} // namespace qm
