#include "document/sections/constraints_section.h"

#include "base/at.h"
#include "document/sections/mesh_paths.h"

namespace qm {

namespace {

class Reader {
public:
    Reader(const QuadMesh& mesh, const BaseComplex& complex)
        : mesh_(mesh), onLine_(edgesOnLines(mesh, complex)), required_(mesh.n_edges()),
          forbidden_(mesh.n_edges()) {}

    enum class Demand { required, forbidden };

    std::vector<EdgeId> read(const JsonPlace& list, Demand demand) {
        const bool isRequired = demand == Demand::required;
        std::vector<bool>& known = isRequired ? required_ : forbidden_;
        const std::vector<bool>& others = isRequired ? forbidden_ : required_;
        std::vector<EdgeId> edges;
        for (const JsonPlace& entry : list.elements()) {
            const JsonPlace vertices = entry["vertices"];
            for (const auto& [edge, end] : edgesAlong(vertices)) {
                if (mesh_.is_boundary(edge)) {
                    if (isRequired) continue;
                    vertices.failAt(
                        end, "the edge to this vertex is on the mesh boundary, which always bounds patches");
                }
                verifyOnLine(edge, vertices, end);
                if (others[at(edge)])
                    vertices.failAt(end, "the edge to this vertex is both required and forbidden");
                if (!known[at(edge)]) edges.push_back(edge);
                known[at(edge)] = true;
            }
        }
        return edges;
    }

    std::vector<std::pair<EdgeId, double>> readWeights(const JsonPlace& list) {
        std::vector<bool> known(mesh_.n_edges());
        std::vector<std::pair<EdgeId, double>> weights;
        for (const JsonPlace& entry : list.elements()) {
            const JsonPlace vertices = entry["vertices"];
            const double weight = entry["weight"].number();
            for (const auto& [edge, end] : edgesAlong(vertices)) {
                verifyOnLine(edge, vertices, end);
                if (known[at(edge)]) vertices.failAt(end, "the edge to this vertex has a weight already");
                known[at(edge)] = true;
                weights.emplace_back(edge, weight);
            }
        }
        return weights;
    }

private:
    struct PathEdge {
        EdgeId edge;
        std::size_t end; ///< position in the list of the vertex to which it leads
    };

    void verifyOnLine(EdgeId edge, const JsonPlace& vertices, std::size_t end) const {
        if (!onLine_[at(edge)])
            vertices.failAt(end, "the edge to this vertex lies on no separatrix, so no patch can end there",
                            "Choose edges of separatrices or of lines with a feature seed");
    }

    [[nodiscard]] std::vector<PathEdge> edgesAlong(const JsonPlace& vertices) const {
        std::vector<PathEdge> edges;
        for (const HalfedgeId halfedge : pathAt(mesh_, vertices))
            edges.push_back({mesh_.edge_handle(halfedge), edges.size() + 1});
        return edges;
    }

    const QuadMesh& mesh_;
    std::vector<bool> onLine_;
    std::vector<bool> required_;
    std::vector<bool> forbidden_;
};

} // namespace

Constraints readConstraints(const QuadMesh& mesh, const BaseComplex& complex, const JsonPlace& section) {
    Reader reader(mesh, complex);
    Constraints constraints;
    if (const auto list = section.find("required"))
        constraints.required = reader.read(*list, Reader::Demand::required);
    if (const auto list = section.find("forbidden"))
        constraints.forbidden = reader.read(*list, Reader::Demand::forbidden);
    if (const auto list = section.find("weights")) constraints.weights = reader.readWeights(*list);
    return constraints;
}

} // namespace qm
