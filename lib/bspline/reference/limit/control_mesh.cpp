#include "bspline/reference/limit/control_mesh.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/reference/lattice/vertex_stencil.h"
#include "bspline/splines/eigen_point.h"
#include "mesh/bounding_box.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// The second may be no number, and then counts as infinite.
double larger(double a, double b) {
    return std::isnan(b) ? infinity : std::max(a, b);
}

/// The limit at every vertex, as rows of a sparse matrix, in the unknown displacements of the control points
/// from the mesh's vertices: they stay small, wherever the mesh lies.
class Displacements {
public:
    Displacements(const QuadMesh& mesh, const std::vector<VertexRule>& rules)
        : component_(components(mesh)), unknown_(mesh.n_vertices(), Eigen::Vector3d::Zero()) {
        begin_.reserve(mesh.n_vertices() + 1);
        for (const VertexId vertex : mesh.vertices()) {
            const VertexStencil stencil = limitStencil(mesh, vertex, rules[at(vertex)]);
            Eigen::Vector3d missing = Eigen::Vector3d::Zero();
            begin_.push_back(column_.size());
            own_.push_back(stencil.own);
            for (const VertexStencil::Term& term : stencil.around) {
                const HalfedgeId onward =
                    term.diagonal ? mesh.next_halfedge_handle(term.halfedge) : term.halfedge;
                const VertexId other = mesh.to_vertex_handle(onward);
                column_.push_back(other.idx());
                weight_.push_back(term.weight);
                missing += term.weight * vector(mesh.point(vertex) - mesh.point(other));
            }
            missing_.push_back(missing);
        }
        begin_.push_back(column_.size());
    }

    /// \param accuracy  a length
    /// \return  by vertex: is its component solved?
    std::vector<bool> solve(double accuracy) {
        constexpr int maxSweeps = 300; // ten times what real meshes take: more means a singular system
        std::vector<std::size_t> active(own_.size());
        for (std::size_t row = 0; row < active.size(); ++row)
            active[row] = row;
        std::vector<bool> solved(at(component_.count));
        std::vector<double> residual(solved.size());
        for (int sweep = 0; sweep < maxSweeps && !active.empty(); ++sweep) {
            std::ranges::fill(residual, 0);
            for (const std::size_t row : active) {
                double& largest = residual[at(component_.ofVertex[row])];
                largest = larger(largest, relax(row));
            }
            bool some = false;
            for (std::size_t k = 0; k < solved.size(); ++k)
                if (!solved[k] && residual[k] <= accuracy * accuracy) solved[k] = some = true;
            if (some)
                std::erase_if(active, [&](std::size_t row) { return solved[at(component_.ofVertex[row])]; });
        }
        rejectFarAway(solved);
        std::vector<bool> ofVertex(own_.size());
        for (std::size_t row = 0; row < ofVertex.size(); ++row)
            ofVertex[row] = solved[at(component_.ofVertex[row])];
        return ofVertex;
    }

    Point operator[](std::size_t vertex) const { return point(unknown_[vertex]); }

private:
    /// \return the squared residual of the row before
    double relax(std::size_t row) {
        // Measured on real meshes: takes 23 to 30 sweeps, 1 about 35 and 1.4 about 50.
        constexpr double overRelaxation = 1.15;
        Eigen::Vector3d sum = missing_[row] - own_[row] * unknown_[row];
        for (std::size_t k = begin_[row]; k < begin_[row + 1]; ++k)
            sum -= weight_[k] * unknown_[at(column_[k])];
        unknown_[row] += overRelaxation / own_[row] * sum;
        return sum.squaredNorm();
    }

    /// In a regular mesh no control point is moved by more than nine times the largest distance of a vertex
    /// from the limit of the mesh itself. One that moves far more is in a nearly singular place.
    void rejectFarAway(std::vector<bool>& solved) const {
        constexpr double far = 30; // more than three times those nine
        std::vector<double> missing(solved.size());
        std::vector<double> moved(solved.size());
        for (std::size_t row = 0; row < own_.size(); ++row) {
            const std::size_t k = at(component_.ofVertex[row]);
            missing[k] = std::max(missing[k], missing_[row].squaredNorm());
            moved[k] = larger(moved[k], unknown_[row].squaredNorm());
        }
        for (std::size_t k = 0; k < solved.size(); ++k)
            if (!(moved[k] <= far * far * missing[k])) solved[k] = false;
    }

    Components component_;
    std::vector<std::size_t> begin_; ///< of every row in column_ and weight_, and their end
    std::vector<int> column_;
    std::vector<double> weight_;
    std::vector<double> own_;              ///< the diagonal
    std::vector<Eigen::Vector3d> missing_; ///< right-hand side
    std::vector<Eigen::Vector3d> unknown_;
};

} // namespace

ControlMesh interpolatingControlMesh(const QuadMesh& mesh, const std::vector<VertexRule>& rules) {
    Displacements displacements(mesh, rules);
    ControlMesh control;
    control.interpolates = displacements.solve(1e-12 * boundingBox(mesh).diagonal());
    control.points.reserve(mesh.n_vertices());
    for (const VertexId vertex : mesh.vertices()) {
        const std::size_t k = at(vertex);
        control.points.push_back(control.interpolates[k] ? mesh.point(vertex) + displacements[k]
                                                         : mesh.point(vertex));
    }
    return control;
}

} // namespace qm
