#include "prune/cornerless_segments.h"

#include "base/at.h"
#include "base/infinity.h"
#include "layout/seed_line.h"
#include "mesh/topology.h"
#include "prune/annuli.h"

#include <utility>

namespace qm {
namespace {

using OneIf = GridProgram::Indicator::OneIf;

/// Adds a row: the column is 1 unless one of the arcs is in.
void requireSome(GridProgram& grids, const std::vector<ArcId>& arcs, ColumnId column) {
    IntegerProgram::Row row{{column}, {1}, 1, infinity};
    for (const ArcId arc : arcs)
        row.columns.push_back(GridProgram::columnOf(arc));
    row.weights.resize(row.columns.size(), 1);
    grids.program.rows.push_back(std::move(row));
}

/// Adds rows: the column is 0 if one of the arcs is in.
void excludeAll(GridProgram& grids, const std::vector<ArcId>& arcs, ColumnId column) {
    for (const ArcId arc : arcs)
        grids.program.rows.push_back({{column, GridProgram::columnOf(arc)}, {1, 1}, 0, 1});
}

/// The faces and arcs of a component without sources of separatrices.
struct SourcelessComponent {
    std::vector<FaceId> faces;
    std::vector<ArcId> arcs; ///< on lines that begin at seeds
};

std::vector<SourcelessComponent> sourcelessComponents(const QuadMesh& mesh, const BaseComplex& complex,
                                                      const ArcGraph& graph) {
    const Components parts = components(mesh);
    std::vector<bool> sourceless(at(parts.count), true);
    for (const VertexId vertex : mesh.vertices())
        if (!isRegular(mesh, vertex) || mesh.is_isolated(vertex) || mesh.valence(vertex) == 2)
            sourceless[at(parts.ofVertex[at(vertex)])] = false;
    const auto partOf = [&](HalfedgeId halfedge) {
        return at(parts.ofVertex[at(mesh.to_vertex_handle(halfedge))]);
    };
    std::vector<SourcelessComponent> all(sourceless.size());
    for (const FaceId face : mesh.faces())
        all[partOf(mesh.halfedge_handle(face))].faces.push_back(face);
    for (std::size_t arc = 0; arc < graph.arcs.size(); ++arc)
        all[partOf(halfedgesOf(graph, complex, ArcId(arc)).front())].arcs.emplace_back(arc);
    std::vector<SourcelessComponent> result;
    for (std::size_t part = 0; part < all.size(); ++part)
        if (sourceless[part]) result.push_back(std::move(all[part]));
    return result;
}

} // namespace

void addAnnuli(const QuadMesh& mesh, GridProgram& grids) {
    const AnnulusBands bands = annulusBands(mesh, grids.arcOf);
    std::vector<ColumnId> columns; // for every band, 1 if it lies in an annulus
    for (const std::vector<ArcId>& across : bands.across) {
        columns.push_back(grids.addIndicator({across, OneIf::noneIsIn}, 4));
        requireSome(grids, across, columns.back());
    }
    for (const AnnulusBands::Joint& joint : bands.joints) {
        std::vector<ArcId> arcs = joint.arcs;
        for (const std::size_t band : joint.bands)
            arcs.insert(arcs.end(), bands.across[band].begin(), bands.across[band].end());
        const ColumnId column = grids.addIndicator({std::move(arcs), OneIf::noneIsIn}, -4);
        for (const std::size_t band : joint.bands)
            grids.program.rows.push_back({{columns[band], column}, {1, -1}, 0, infinity});
        excludeAll(grids, joint.arcs, column);
    }
}

void addSeedLines(const PrunedMesh& pruned, GridProgram& grids) {
    const auto& [mesh, complex, dihedralAngles, edgeCosts] = pruned;
    for (const auto& [faces, arcs] : sourcelessComponents(mesh, complex, grids.graph)) {
        const std::vector<HalfedgeId> line = seedLine(mesh, faces, dihedralAngles);
        // A loop turns a torus into one annulus, or one annulus into two; a line between borders makes one
        // grid.
        const bool loop = !mesh.is_boundary(mesh.from_vertex_handle(line.front()));
        const ColumnId column =
            grids.addIndicator({arcs, OneIf::noneIsIn}, loop ? 4 : 0, sumAlong(mesh, line, edgeCosts));
        requireSome(grids, arcs, column);
        excludeAll(grids, arcs, column);
    }
}

} // namespace qm
