#include "bspline/reference/limit/unfolded_lattice.h"

#include "base/at.h"
#include "base/parallel.h"
#include "base/sort_unique.h"
#include "bspline/reference/lattice/bilinear_quad.h"
#include "bspline/reference/lattice/sound_faces.h"
#include "bspline/reference/limit/edge_curves.h"
#include "bspline/splines/spline_curve.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// Smallest cosine of the angle between a curve and the edge below it: 60 degrees.
constexpr double minCosine = 0.5;
/// Largest number of passes over the mesh. Folds take one a stage; those that spread farther are left.
constexpr int maxPasses = 12;

/// How much of interpolation is given up. A face is as far as it folds, an edge as far as a face beside it.
enum Stage : char { interpolated, betweenEnds, halfStraight, nearlyStraight, straight };

class Unfolding {
public:
    Unfolding(MeshLattice& lattice, const Sharpness& sharpness, const PlaneCorners* corners,
              const FoldLimits& limits, unsigned jobs)
        : lattice_(lattice), mesh_(lattice.numbers().mesh()), squares_(lattice.squares()),
          sharpness_(sharpness), corners_(corners), jobs_(jobs), test_(lattice, limits),
          isUpright_(uprightFaces(mesh_, sharpness.edges, jobs)), faceStages_(mesh_.n_faces(), interpolated),
          edgeStages_(mesh_.n_edges(), interpolated) {}

    void run() {
        std::vector<FaceId> folded = foldedAmong(std::vector<FaceId>(mesh_.faces_begin(), mesh_.faces_end()));
        if (folded.empty()) return;
        const MeshLattice before = lattice_;
        const EdgeCurves curves(mesh_, sharpness_, corners_);
        for (int pass = 0; pass < maxPasses && !folded.empty(); ++pass) {
            const std::vector<FaceId> changed = redrawAround(folded, curves);
            parallelForMany(changed.size(), jobs_, [&](std::size_t k) { fill(changed[k], before); });
            folded = foldedAmong(changed);
        }
    }

private:
    [[nodiscard]] double share(int k) const { return static_cast<double>(k) / squares_; }

    /// Faces that were drawn along with their neighbours may fold for that reason.
    /// \return those about which more can be done
    std::vector<FaceId> foldedAmong(const std::vector<FaceId>& faces) {
        std::vector<char> isFolded(faces.size());
        parallelForMany(faces.size(), jobs_, [&](std::size_t k) {
            Stage& stage = faceStages_[at(faces[k])];
            if (stage == straight || !isUpright_[at(faces[k])] || !test_.foldsOver(faces[k])) return;
            stage = static_cast<Stage>(stage + 1);
            isFolded[k] = 1;
        });
        std::vector<FaceId> folded;
        for (std::size_t k = 0; k < faces.size(); ++k)
            if (isFolded[k] != 0) folded.push_back(faces[k]);
        return folded;
    }

    /// \return the faces, and those beside an edge whose curve has changed
    std::vector<FaceId> redrawAround(std::vector<FaceId> faces, const EdgeCurves& curves) {
        const std::size_t count = faces.size();
        for (std::size_t k = 0; k < count; ++k)
            for (const EdgeId edge : mesh_.fe_range(faces[k])) {
                if (!redraw(edge, curves)) continue;
                for (const FaceId face : facesBeside(mesh_, edge))
                    if (face.is_valid()) faces.push_back(face);
            }
        sortUnique(faces);
        return faces;
    }

    /// Draws the curve above an edge as the faces beside it demand.
    /// \return whether it has changed
    bool redraw(EdgeId edge, const EdgeCurves& curves) {
        const Stage stage = stageBeside(edge);
        Stage& drawn = edgeStages_[at(edge)];
        if (stage <= drawn) return false;
        if (stage == betweenEnds && sharpness_.edges[at(edge)] && !turnsBack(edge)) return false;
        drawn = stage;
        const HalfedgeId halfedge = mesh_.halfedge_handle(edge, 0);
        if (stage == betweenEnds)
            drawBetweenEnds(halfedge, curves);
        else
            straighten(halfedge, stage == straight ? 1 : 0.5);
        return true;
    }

    /// The later stage of the faces beside an edge, but the first change only where both are upright: what
    /// straightens the curve serves the upright face, whatever the other is.
    [[nodiscard]] Stage stageBeside(EdgeId edge) const {
        Stage stage = interpolated;
        bool areUpright = true;
        for (const FaceId face : facesBeside(mesh_, edge)) {
            if (!face.is_valid()) continue;
            areUpright = areUpright && isUpright_[at(face)];
            stage = std::max(stage, faceStages_[at(face)]);
        }
        return stage == betweenEnds && !areUpright ? interpolated : stage;
    }

    /// The curve above an edge somewhere goes back, or nearly so.
    [[nodiscard]] bool turnsBack(EdgeId edge) const {
        const auto point = [&](int k) { return lattice_.point(mesh_.halfedge_handle(edge, 0), k, 0); };
        const Point chord = unit(point(squares_) - point(0));
        for (int k = 0; k < squares_; ++k) {
            const Point step = point(k + 1) - point(k);
            if (!((step | chord) >= minCosine * step.norm())) return true;
        }
        return false;
    }

    void drawBetweenEnds(HalfedgeId halfedge, const EdgeCurves& curves) {
        const SplineCurve curve = bezier(curves.above(halfedge), 1);
        lattice_.moveEdge(halfedge, [&](int k) { return evaluate(curve, share(k)); });
    }

    /// Moves a curve by a share of the way to its edge.
    void straighten(HalfedgeId halfedge, double way) {
        const Point begin = lattice_.point(halfedge, 0, 0);
        const Point chord = lattice_.point(halfedge, squares_, 0) - begin;
        lattice_.moveEdge(halfedge, [&](int k) {
            return (1 - way) * lattice_.point(halfedge, k, 0) + way * (begin + share(k) * chord);
        });
    }

    void fill(FaceId face, const MeshLattice& before) {
        if (faceStages_[at(face)] != interpolated)
            fill(face, [&, quad = test_.quad(face)](int i, int j) {
                return quad.evaluate(share(i), share(j)).position;
            });
        else if (std::ranges::any_of(mesh_.fe_range(face),
                                     [&](EdgeId edge) { return edgeStages_[at(edge)] != interpolated; }))
            fill(face, [&](int i, int j) { return before.point(face, i, j); });
    }

    /// Puts the inner points where a form has them, moved as the form's border is to be moved to get to the
    /// face's; the corners are the same (docs/METHOD.md#coons-1967).
    template <class Form> void fill(FaceId face, const Form& form) {
        const auto missing = [&](int i, int j) { return lattice_.point(face, i, j) - form(i, j); };
        lattice_.moveInside(face, [&](int i, int j) {
            const double s = share(i), t = share(j);
            return form(i, j) + (1 - t) * missing(i, 0) + t * missing(i, squares_) + (1 - s) * missing(0, j) +
                   s * missing(squares_, j);
        });
    }

    MeshLattice& lattice_;
    const QuadMesh& mesh_;
    int squares_;
    Sharpness sharpness_;
    const PlaneCorners* corners_;
    unsigned jobs_;
    FoldTest test_;
    std::vector<bool> isUpright_; ///< by face
    std::vector<Stage> faceStages_;
    std::vector<Stage> edgeStages_;
};

} // namespace

void unfold(MeshLattice& lattice, const Sharpness& sharpness, const PlaneCorners* corners,
            const FoldLimits& limits, unsigned jobs) {
    Unfolding(lattice, sharpness, corners, limits, jobs).run();
}

} // namespace qm
