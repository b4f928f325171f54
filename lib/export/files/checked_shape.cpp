#include "export/files/checked_shape.h"

#include "export/boundary/divided_edges.h"
#include "export/boundary/face_order.h"
#include "export/boundary/merge.h"
#include "export/boundary/outline.h"

#include <BRepCheck_Analyzer.hxx>
#include <algorithm>
#include <set>
#include <utility>

namespace qm {
namespace {

/// What every step ends with.
using Judge = CheckedShape (*)(Boundary, const FaceOrigins&);

/// Takes for granted that there are no faults, and builds no shape.
CheckedShape trusted(Boundary boundary, const FaceOrigins& origins) {
    orderFaces(boundary);
    CheckedShape made{std::move(boundary), origins, {}, true};
    made.isFaceSound.assign(made.boundary.faces.size(), true);
    return made;
}

CheckedShape checked(Boundary boundary, const FaceOrigins& origins) {
    CheckedShape made = trusted(std::move(boundary), origins);
    made.shape = buildShape(made.boundary);
    const BRepCheck_Analyzer check(made.shape.shape, Standard_True, Standard_True);
    made.isValid = check.IsValid();
    if (!made.isValid)
        for (const BoundaryPart& part : made.boundary.parts)
            for (const std::size_t face : part.faces) {
                const TopoDS_Face& own = made.shape.faces[face];
                // Of a shell that is reversed, the analyser knows the faces reversed.
                made.isFaceSound[face] = check.IsValid(part.inward ? own.Reversed() : TopoDS_Shape(own));
            }
    for (std::size_t f = 0; f < made.isFaceSound.size(); ++f)
        if (made.boundary.faces[f].isSimple && outlineCrossesItself(made.boundary, f))
            made.isFaceSound[f] = false;
    return made;
}

/// So often, merged faces that OpenCASCADE does not take are tried again without those of their parts that
/// are to blame; then they are not merged at all.
constexpr int maxTrials = 4;

/// Which faces merged faces with faults consist of.
struct Blame {
    std::set<std::size_t> segments;     ///< all of them
    std::set<const Geom_Curve*> faulty; ///< curves of edges that make no outline
};

Blame blameOf(const CheckedShape& made) {
    Blame blame;
    for (std::size_t f = 0; f < made.isFaceSound.size(); ++f) {
        if (made.isFaceSound[f]) continue;
        blame.segments.insert(made.origins[f].begin(), made.origins[f].end());
        for (const std::size_t edge : faultyEdges(made.boundary, f))
            blame.faulty.insert(made.boundary.edges[edge].curve.curve.get());
    }
    return blame;
}

/// The same with merged faces, except where OpenCASCADE does not take them: where the outline of a merged
/// face crosses itself, for instance around quads that are turned over within a plane, the faces there stay
/// apart.
CheckedShape withMergedFaces(const CheckedShape& shape, MergedSurface kind, Judge judge) {
    std::vector<bool> mayMerge(shape.boundary.faces.size(), true);
    for (int trial = 0;; ++trial) {
        Boundary boundary = shape.boundary;
        FaceOrigins origins = shape.origins;
        if (!mergeFaces(boundary, origins, kind, mayMerge)) return shape;
        CheckedShape made = judge(std::move(boundary), origins);
        if (made.isSound() || !shape.isSound()) return made;
        const Blame blame = blameOf(made);
        const auto isThere = [&](std::size_t f) {
            return std::ranges::any_of(shape.boundary.faces[f].loops.front(), [&](const EdgeUse& use) {
                return blame.faulty.contains(shape.boundary.edges[use.edge].curve.curve.get());
            });
        };
        const auto reject = [&](const auto& isRejected) {
            bool isAny = false;
            for (std::size_t f = 0; f < mayMerge.size(); ++f)
                if (mayMerge[f] && blame.segments.contains(shape.origins[f].front()) && isRejected(f)) {
                    mayMerge[f] = false;
                    isAny = true;
                }
            return isAny;
        };
        if (trial < maxTrials && reject(isThere)) continue;
        if (!reject([](std::size_t) { return true; })) return shape;
    }
}

/// The same with edges changed, if OpenCASCADE takes that.
/// \param change  whether it has changed anything
CheckedShape withEdges(CheckedShape shape, bool (*change)(Boundary&), Judge judge) {
    Boundary boundary = shape.boundary;
    if (!change(boundary)) return shape;
    CheckedShape made = judge(std::move(boundary), shape.origins);
    return made.isSound() || !shape.isSound() ? made : shape;
}

/// With as many simple surfaces as OpenCASCADE takes.
CheckedShape simplified(const QuadMesh& mesh, const FacePatches& faces, double simplify, Judge judge) {
    std::vector<double> simplifyFace(faces.patches.size(), simplify);
    while (true) {
        CheckedShape made = judge(makeBoundary(mesh, faces, simplifyFace), faces.origins);
        if (made.isSound()) return made;
        bool changed = false;
        for (std::size_t f = 0; f < simplifyFace.size(); ++f)
            if (simplifyFace[f] > 0 && !made.isFaceSound[f]) {
                simplifyFace[f] = 0;
                changed = true;
            }
        if (!changed) return made;
    }
}

/// With faces and edges merged and divided.
CheckedShape finished(CheckedShape made, bool simplify, bool join, Judge judge) {
    if (join) {
        for (const MergedSurface kind : {MergedSurface::plane, MergedSurface::ruled})
            made = withMergedFaces(made, kind, judge);
        made = withEdges(std::move(made), mergeEdges, judge);
    }
    made = withEdges(std::move(made), divideTwistedEdges, judge);
    return simplify ? withEdges(std::move(made), divideLooseEdges, judge) : made;
}

/// Checked, if it is not yet.
CheckedShape surely(CheckedShape shape) {
    return shape.shape.faces.empty() ? checked(std::move(shape.boundary), shape.origins) : shape;
}

} // namespace

bool CheckedShape::isSound() const {
    return isValid && std::ranges::find(isFaceSound, false) == isFaceSound.end();
}

CheckedShape checkedShape(const QuadMesh& mesh, const FacePatches& faces, std::optional<double> simplify,
                          bool join) {
    const bool tries = simplify.has_value();
    const CheckedShape plain = simplified(mesh, faces, simplify.value_or(0), tries ? checked : trusted);
    // OpenCASCADE's check takes most of the time, and most shapes have no faults: one check of the last step
    // is enough for them.
    CheckedShape made = surely(finished(plain, tries, join, trusted));
    return made.isSound() ? made : finished(surely(plain), tries, join, checked);
}

} // namespace qm
