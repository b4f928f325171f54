#include "export/files/shape.h"

#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

namespace qm {
namespace {

class ShapeBuilder {
public:
    explicit ShapeBuilder(const Boundary& boundary) : boundary_(boundary) {
        for (const BoundaryVertex& vertex : boundary.vertices)
            builder_.MakeVertex(vertices_.emplace_back(), vertex.point, vertex.tolerance);
        for (const BoundaryEdge& edge : boundary.edges) {
            TopoDS_Edge& made = edges_.emplace_back();
            builder_.MakeEdge(made, edge.curve.curve, edge.tolerance);
            builder_.Add(made, vertices_[edge.ends[0]].Oriented(TopAbs_FORWARD));
            builder_.Add(made, vertices_[edge.ends[1]].Oriented(TopAbs_REVERSED));
            builder_.Range(made, edge.curve.first, edge.curve.last);
        }
    }

    BoundaryShape build() {
        BoundaryShape result;
        for (const BoundaryFace& face : boundary_.faces)
            result.faces.push_back(makeFace(face));
        std::vector<TopoDS_Shape> bodies;
        for (const BoundaryBody& body : bodiesOf(boundary_.parts))
            bodies.push_back(makeBody(body, result.faces));
        result.shape = bodies.size() == 1 ? bodies.front() : compound(bodies);
        return result;
    }

private:
    TopoDS_Face makeFace(const BoundaryFace& face) {
        TopoDS_Face result;
        builder_.MakeFace(result, face.surface, Precision::Confusion());
        for (const auto& loop : face.loops) {
            TopoDS_Wire wire;
            builder_.MakeWire(wire);
            for (const EdgeUse& use : loop)
                addUse(use, wire, result);
            wire.Closed(true);
            builder_.Add(result, face.reversed ? wire.Reversed() : wire);
        }
        if (face.reversed) result.Reverse();
        return result;
    }

    void addUse(const EdgeUse& use, TopoDS_Wire& wire, const TopoDS_Face& face) {
        const BoundaryEdge& edge = boundary_.edges[use.edge];
        if (const auto& curve = edge.onFaces.at(use.side()); !curve.IsNull()) {
            builder_.UpdateEdge(edges_[use.edge], curve, face, edge.tolerance);
            builder_.Range(edges_[use.edge], face, curve->FirstParameter(), curve->LastParameter());
        }
        builder_.Add(wire, edges_[use.edge].Oriented(use.forwards ? TopAbs_FORWARD : TopAbs_REVERSED));
    }

    TopoDS_Shape makeBody(const BoundaryBody& body, const std::vector<TopoDS_Face>& faces) {
        const TopoDS_Shape outer = makeShell(*body.outer, faces);
        if (!body.outer->closed) return outer;
        TopoDS_Solid solid;
        builder_.MakeSolid(solid);
        builder_.Add(solid, outer);
        for (const BoundaryPart* cavity : body.cavities)
            builder_.Add(solid, makeShell(*cavity, faces));
        return solid;
    }

    TopoDS_Shape makeShell(const BoundaryPart& part, const std::vector<TopoDS_Face>& faces) {
        TopoDS_Shell shell;
        builder_.MakeShell(shell);
        for (const std::size_t face : part.faces)
            builder_.Add(shell, faces[face]);
        shell.Closed(part.closed);
        return part.inward ? shell.Reversed() : TopoDS_Shape(shell);
    }

    TopoDS_Shape compound(const std::vector<TopoDS_Shape>& bodies) {
        TopoDS_Compound result;
        builder_.MakeCompound(result);
        for (const TopoDS_Shape& body : bodies)
            builder_.Add(result, body);
        return result;
    }

    const Boundary& boundary_;
    std::vector<TopoDS_Vertex> vertices_;
    std::vector<TopoDS_Edge> edges_;
    BRep_Builder builder_;
};

} // namespace

BoundaryShape buildShape(const Boundary& boundary) {
    return ShapeBuilder(boundary).build();
}

} // namespace qm
