#include "bspline/reference/limit/crease_directions.h"

#include "base/at.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace qm {
namespace {

/// A vertex that a curve passes, and its share of the equations of the spline's derivatives.
struct Passage {
    /// Of the neighbours along both edges: their places in the list of passages, or none at an end of the
    /// curve.
    std::array<std::optional<std::size_t>, 2> neighbours;
    std::array<double, 2> signs{1, 1}; ///< -1 if the neighbour's derivative points against the curve
    std::array<double, 2> weights{};   ///< of the neighbours' derivatives
    double weight = 0;                 ///< of the vertex's own
    Point side;                        ///< the equation's right-hand side
    Point derivative;                  ///< by length, into the first edge
};

class CreaseSpline {
public:
    CreaseSpline(const QuadMesh& mesh, const std::vector<VertexRule>& rules)
        : mesh_(mesh), rules_(rules), places_(rules.size()) {
        for (std::size_t vertex = 0; vertex < rules.size(); ++vertex)
            if (passes(vertex)) {
                places_[vertex] = vertices_.size();
                vertices_.push_back(vertex);
            }
        for (const std::size_t vertex : vertices_)
            passages_.push_back(passageOf(rules[vertex].along));
    }

    /// The equations are those of cubic splines that end as parabolas. Each sweep at least halves the error.
    void solve() {
        constexpr int sweeps = 45;
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (Passage& passage : passages_) {
                Point sum = passage.side;
                for (std::size_t k = 0; k < 2; ++k)
                    if (passage.neighbours[k])
                        sum -= passage.weights[k] * passage.signs[k] *
                               passages_[*passage.neighbours[k]].derivative;
                passage.derivative = sum / passage.weight;
            }
    }

    [[nodiscard]] std::vector<Point> directions() const {
        std::vector<Point> result(rules_.size(), Point(0, 0, 0));
        for (std::size_t k = 0; k < vertices_.size(); ++k)
            result[vertices_[k]] = unit(passages_[k].derivative);
        return result;
    }

private:
    [[nodiscard]] bool passes(std::size_t vertex) const {
        const auto hasLength = [&](HalfedgeId halfedge) {
            return mesh_.calc_edge_vector(halfedge).sqrnorm() > 0;
        };
        return rules_[vertex].kind == VertexRule::Kind::crease &&
               std::ranges::all_of(rules_[vertex].along, hasLength);
    }

    [[nodiscard]] Passage passageOf(const std::array<HalfedgeId, 2>& along) const {
        Passage passage;
        const std::array chords{mesh_.calc_edge_vector(along[0]),
                                -mesh_.calc_edge_vector(along[1])}; // both along the curve
        const std::array lengths{chords[0].norm(), chords[1].norm()};
        passage.weight = 2 * (lengths[0] + lengths[1]);
        passage.side = Point(0, 0, 0);
        for (std::size_t k = 0; k < 2; ++k) {
            const double other = lengths[1 - k];
            const Point slope = chords[k] / lengths[k];
            passage.side += 3 * other * slope;
            passage.weights[k] = other;
            const std::size_t next = at(mesh_.to_vertex_handle(along[k]));
            const auto& beyond = rules_[next].along;
            const HalfedgeId back = mesh_.opposite_halfedge_handle(along[k]);
            if (places_[next] && (beyond[0] == back || beyond[1] == back)) {
                passage.neighbours[k] = places_[next];
                passage.signs[k] = beyond[1 - k] == back ? 1 : -1;
            } else { // its derivative is expressed by this one
                passage.weight -= other;
                passage.side -= 2 * other * slope;
            }
        }
        passage.derivative = passage.side / passage.weight;
        return passage;
    }

    const QuadMesh& mesh_;
    const std::vector<VertexRule>& rules_;
    std::vector<std::optional<std::size_t>> places_; ///< by vertex, in both lists
    std::vector<std::size_t> vertices_;
    std::vector<Passage> passages_;
};

} // namespace

std::vector<Point> creaseDirections(const QuadMesh& mesh, const std::vector<VertexRule>& rules) {
    CreaseSpline spline(mesh, rules);
    spline.solve();
    return spline.directions();
}

} // namespace qm
