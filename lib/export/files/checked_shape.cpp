#include "export/files/checked_shape.h"

#include "export/boundary/face_order.h"
#include "export/boundary/loose_edges.h"
#include "export/boundary/merge_edges.h"
#include "export/boundary/merge_faces.h"
#include "export/boundary/outline.h"

#include <BRepCheck_Analyzer.hxx>
#include <algorithm>
#include <set>
#include <utility>

namespace qm {
namespace {

using Origins = std::vector<std::vector<std::size_t>>;

CheckedShape checked(Boundary boundary, const Origins& origins) {
    orderFaces(boundary);
    CheckedShape made{std::move(boundary), origins, {}};
    made.shape = buildShape(made.boundary);
    const BRepCheck_Analyzer check(made.shape.shape, Standard_True, Standard_True);
    made.isValid = check.IsValid();
    made.isFaceSound.assign(made.shape.faces.size(), true);
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

/// The same with merged faces, except where OpenCASCADE does not take them.
CheckedShape withMergedFaces(const CheckedShape& shape, MergedSurface kind) {
    std::vector<bool> mayMerge(shape.boundary.faces.size(), true);
    while (true) {
        Boundary boundary = shape.boundary;
        Origins origins = shape.origins;
        if (!mergeFaces(boundary, origins, kind, mayMerge)) return shape;
        CheckedShape made = checked(std::move(boundary), origins);
        if (made.isSound() || !shape.isSound()) return made;
        std::set<std::size_t> rejected; // segments
        for (std::size_t f = 0; f < made.isFaceSound.size(); ++f)
            if (!made.isFaceSound[f]) rejected.insert(made.origins[f].begin(), made.origins[f].end());
        bool isAny = false;
        for (std::size_t f = 0; f < mayMerge.size(); ++f)
            if (mayMerge[f] && rejected.contains(shape.origins[f].front())) {
                mayMerge[f] = false;
                isAny = true;
            }
        if (!isAny) return shape;
    }
}

/// The same with edges changed, if OpenCASCADE takes that.
/// \param change  called with the boundary; whether it has changed anything
template <class Change> CheckedShape withEdges(CheckedShape shape, const Change& change) {
    Boundary boundary = shape.boundary;
    if (!change(boundary)) return shape;
    CheckedShape made = checked(std::move(boundary), shape.origins);
    return made.isSound() || !shape.isSound() ? made : shape;
}

} // namespace

bool CheckedShape::isSound() const {
    return isValid && std::ranges::find(isFaceSound, false) == isFaceSound.end();
}

CheckedShape checkedShape(const QuadMesh& mesh, const FacePatches& faces, double simplify) {
    std::vector<double> simplifyFace(faces.patches.size(), simplify);
    while (true) {
        CheckedShape made = checked(makeBoundary(mesh, faces, simplifyFace), faces.origins);
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

CheckedShape withLooseEdgesDivided(CheckedShape shape) {
    return withEdges(std::move(shape), divideLooseEdges);
}

CheckedShape merged(CheckedShape shape) {
    for (const MergedSurface kind : {MergedSurface::plane, MergedSurface::ruled})
        shape = withMergedFaces(shape, kind);
    return withEdges(std::move(shape), mergeEdges);
}

} // namespace qm
