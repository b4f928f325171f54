#include "bspline/reference/planes/in_planes.h"

#include "base/at.h"
#include "bspline/reference/lattice/hermite.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/planes/orthogonal_normals.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace qm {
namespace {

using Vector = Eigen::Vector3d;

class LyingInPlanes {
public:
    LyingInPlanes(MeshLattice& lattice, const PlaneCorners& corners, const std::vector<bool>& isCrease)
        : lattice_(lattice), before_(lattice), mesh_(lattice.numbers().mesh()), corners_(corners),
          isCrease_(isCrease), last_(at(lattice.squares())), turns_(mesh_.n_halfedges(), Vector::Zero()),
          hermite_(hermiteByStep(lattice.squares())) {}

    void run(unsigned jobs) {
        std::vector<char> isBound(mesh_.n_vertices());
        parallelForVertices(mesh_, jobs, [&](VertexId vertex) {
            isBound[at(vertex)] = corners_.isBound(vertex) ? 1 : 0;
            if (isBound[at(vertex)] == 0) return;
            for (const HalfedgeId leaving : mesh_.voh_range(vertex)) {
                const Point derivative = before_.derivative(leaving);
                turns_[at(leaving)] = vector(corners_.within(leaving, derivative) - derivative);
            }
        });
        const auto follows = [&](auto&& vertices) {
            return std::ranges::any_of(vertices, [&](VertexId vertex) { return isBound[at(vertex)] != 0; });
        };
        parallelForEdges(mesh_, jobs, [&](EdgeId edge) {
            if (follows(endsOf(mesh_, edge))) moveEdge(mesh_.halfedge_handle(edge, 0));
        });
        parallelForFaces(mesh_, jobs, [&](FaceId face) {
            if (follows(mesh_.fv_range(face))) moveFace(face);
        });
    }

private:
    /// A row of points or derivatives, with one entry for every step.
    using Row = std::vector<Vector>;

    [[nodiscard]] Vector before(HalfedgeId side, std::size_t along, std::size_t depth) const {
        return vector(before_.point(side, static_cast<int>(along), static_cast<int>(depth)));
    }

    [[nodiscard]] const Vector& turn(HalfedgeId leaving) const { return turns_[at(leaving)]; }

    [[nodiscard]] Vector derivative(const Row& row, std::size_t end) const {
        return derivativeAtEnd(before_.squares(), end, [&](int k) -> const Vector& { return row[at(k)]; });
    }

    /// Changes a row so that its values, or derivatives, at both ends are as wanted.
    void addValues(Row& row, const std::array<Vector, 2>& wanted) const {
        const std::array missing{Vector(wanted[0] - row.front()), Vector(wanted[1] - row.back())};
        for (std::size_t k = 0; k <= last_; ++k)
            row[k] += hermite_[k].value[0][0] * missing[0] + hermite_[k].value[1][0] * missing[1];
    }
    void addSlopes(Row& row, const std::array<Vector, 2>& wanted) const {
        const std::array missing{Vector(wanted[0] - derivative(row, 0)),
                                 Vector(wanted[1] - derivative(row, 1))};
        for (std::size_t k = 0; k <= last_; ++k)
            row[k] += hermite_[k].slope[0][0] * missing[0] + hermite_[k].slope[1][0] * missing[1];
    }

    /// How far a vertex is off a plane.
    [[nodiscard]] double off(const Plane& plane, VertexId vertex) const {
        return plane.distance(before_.point(at(vertex)));
    }

    /// Moves a curve the least way into the planes of the quads beside it, and turns its ends.
    void moveEdge(HalfedgeId side) {
        const HalfedgeId back = mesh_.opposite_halfedge_handle(side);
        Row ways(last_ + 1, Vector::Zero());
        OrthogonalNormals normals;
        for (const int part : {corners_.partBeside(side), corners_.partBeside(back)}) {
            if (part == PlaneParts::none) continue;
            const Plane& plane = corners_.plane(part);
            const Vector normal = vector(plane.normal);
            const auto direction = normals.add(normal);
            if (!direction) continue;
            const double begin = off(plane, mesh_.from_vertex_handle(side));
            const double end = off(plane, mesh_.to_vertex_handle(side));
            for (std::size_t k = 0; k <= last_; ++k) {
                const double wanted = hermite_[k].value[0][0] * begin + hermite_[k].value[1][0] * end;
                const double is = plane.distance(point(before(side, k, 0) + ways[k]));
                ways[k] += (wanted - is) / direction->dot(normal) * *direction;
            }
        }
        addSlopes(ways, {turn(side), -turn(back)});
        lattice_.moveEdge(side, [&](int k) { return point(before(side, at(k), 0) + ways[at(k)]); });
    }

    /// The derivatives across a side, inwards, of the points along it.
    [[nodiscard]] Row inward(HalfedgeId side) const {
        Row row(last_ + 1);
        for (std::size_t k = 0; k <= last_; ++k)
            row[k] =
                derivativeAtEnd(before_.squares(), 0, [&](int depth) { return before(side, k, at(depth)); });
        return row;
    }

    /// What a side of a face gains: the ways of its points, and the changes of derivatives across it.
    struct Side {
        Row ways;
        Row across;
        Vector twist; ///< at its beginning
    };

    [[nodiscard]] Side sideOf(HalfedgeId side) const {
        Side result{Row(last_ + 1), Row(last_ + 1, Vector::Zero()), Vector::Zero()};
        for (int k = 0; k <= lattice_.squares(); ++k)
            result.ways[at(k)] = vector(lattice_.point(side, k, 0) - before_.point(side, k, 0));
        const Row inwards = inward(side);
        const auto off = [&](int part, const Vector& derivative) {
            if (part == PlaneParts::none) return Vector(Vector::Zero());
            const Vector normal = vector(corners_.plane(part).normal);
            return Vector(-normal.dot(derivative) * normal);
        };
        const HalfedgeId next = mesh_.next_halfedge_handle(side);
        const std::array twists{off(corners_.partAtCorner(side), derivative(inwards, 0)),
                                off(corners_.partAtCorner(next), derivative(inwards, 1))};
        result.twist = twists[0];
        if (!isCrease_[at(mesh_.edge_handle(side))]) {
            int part = corners_.partBeside(side);
            if (part == PlaneParts::none) part = corners_.partBeside(mesh_.opposite_halfedge_handle(side));
            for (std::size_t k = 0; k <= last_; ++k)
                result.across[k] = off(part, inwards[k]);
        }
        addValues(result.across,
                  {turn(mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(side))), turn(next)});
        addSlopes(result.across, twists);
        return result;
    }

    /// Blends what the sides gain, as Coons does.
    void moveFace(FaceId face) {
        const HalfedgeId first = mesh_.halfedge_handle(face);
        Row ways((last_ + 1) * (last_ + 1), Vector::Zero());
        HalfedgeId side = first;
        for (int turns = 0; turns < 4; ++turns) {
            const Side gain = sideOf(side);
            const Vector& along = turn(side);
            const Vector& inwards = turn(mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(side)));
            for (std::size_t depth = 0; depth <= last_; ++depth)
                for (std::size_t k = 0; k <= last_; ++k) {
                    const Hermite& u = hermite_[k];
                    const Hermite& v = hermite_[depth];
                    ways[place(turns, k, depth)] +=
                        v.value[0][0] * (gain.ways[k] - u.slope[0][0] * along) +
                        v.slope[0][0] *
                            (gain.across[k] - u.value[0][0] * inwards - u.slope[0][0] * gain.twist);
                }
            side = mesh_.next_halfedge_handle(side);
        }
        const int part = corners_.partOf(face);
        std::array<double, 4> offs{}; // the face is to be off its plane as its corners are
        if (part != PlaneParts::none)
            std::ranges::transform(before_.numbers().corners(face), offs.begin(),
                                   [&](VertexId corner) { return off(corners_.plane(part), corner); });
        lattice_.moveInside(first, [&](int i, int j) {
            Point to = point(before(first, at(i), at(j)) + ways[place(0, at(i), at(j))]);
            if (part == PlaneParts::none) return to;
            const Plane& plane = corners_.plane(part);
            const double off = betweenCorners(hermite_[at(i)], hermite_[at(j)], offs);
            return Point(to + (off - plane.distance(to)) * plane.normal);
        });
    }

    /// The place of a point of a face, counted from one of its sides, in a list row by row.
    [[nodiscard]] std::size_t place(int side, std::size_t along, std::size_t depth) const {
        const auto at = [&](std::size_t i, std::size_t j) { return j * (last_ + 1) + i; };
        switch (side) {
        case 0:
            return at(along, depth);
        case 1:
            return at(last_ - depth, along);
        case 2:
            return at(last_ - along, last_ - depth);
        default:
            return at(depth, last_ - along);
        }
    }

    MeshLattice& lattice_;
    const MeshLattice before_;
    const QuadMesh& mesh_;
    const PlaneCorners& corners_;
    const std::vector<bool>& isCrease_;
    std::size_t last_;             ///< steps a quad
    std::vector<Vector> turns_;    ///< by halfedge: what the derivative at its beginning gains
    std::vector<Hermite> hermite_; ///< by step
};

} // namespace

void layInPlanes(MeshLattice& lattice, const PlaneCorners& corners, const std::vector<bool>& isCrease,
                 unsigned jobs) {
    if (!corners.isEmpty()) LyingInPlanes(lattice, corners, isCrease).run(jobs);
}

} // namespace qm
