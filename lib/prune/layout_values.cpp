#include "prune/layout_values.h"

#include "base/at.h"
#include "layout/tracks.h"

#include <algorithm>
#include <iterator>

namespace qm {

ColumnValues valuesOf(const PrunedMesh& pruned, const GridProgram& grids, const Layout& layout) {
    const QuadMesh& mesh = pruned.mesh;
    std::vector<Track> tracks;
    for (const LayoutTrack& track : layout.tracks)
        if (!track.transversal && grids.arcOf[at(mesh.edge_handle(track.track.halfedges.front()))].valid())
            tracks.push_back(track.track);
    return grids.valuesOf(presentArcs({mesh, pruned.complex, grids.graph}, tracks));
}

ColumnValues completed(const GridProgram& grids, const ColumnValues& solved) {
    PresentArcs present(grids.graph.arcs.size());
    for (const ArcId arc : present.ids())
        present[arc] = solved[GridProgram::columnOf(arc)] > 0.5;
    return grids.valuesOf(present);
}

Layout layoutOf(const PrunedMesh& pruned, const GridProgram& grids, const ColumnValues& values) {
    const auto& [mesh, complex, dihedralAngles, edgeCosts] = pruned;
    std::vector<Track> tracks;
    const auto isIn = [&](ArcId arc) { return values[GridProgram::columnOf(arc)] > 0.5; };
    for (const Line& line : grids.graph.lines)
        for (const ArcRun& run : runsOf(line, isIn))
            tracks.push_back(trackOf(mesh, halfedgesOf(grids.graph, complex, run), edgeCosts));
    return buildLayout(mesh, tracks, dihedralAngles, edgeCosts);
}

std::vector<std::vector<ColumnId>> columnsOfLines(const ArcGraph& graph) {
    std::vector<std::vector<ColumnId>> columns;
    for (const Line& line : graph.lines) {
        columns.emplace_back();
        std::ranges::transform(line.arcs(), std::back_inserter(columns.back()), GridProgram::columnOf);
    }
    return columns;
}

} // namespace qm
