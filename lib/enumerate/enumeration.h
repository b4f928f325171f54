/// \file The graphs of every sub-mesh: the result of a search (docs/METHOD.md#sub-meshes).
#pragma once

#include "base/id_vector.h"
#include "layout/cost.h"
#include "layout/motorcycle_graph.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

enum class Method {
    optimum,  ///< branch and bound on arcs; best graph and a lower bound
    naive,    ///< the paper's: all coordinate vectors, filtered (docs/METHOD.md#coordinate-search)
    bounds,   ///< the paper's: rules B1 to B4
    improved, ///< the paper's: rules B1 to B3 and B4'
    plain     ///< the plain motorcycle graph (docs/METHOD.md#plain-graph)
};

/// What a track may begin and end on.
enum class GraphClass {
    motorcycle, ///< rules 1 to 4: every track begins at a source
    tmesh       ///< rules 1 and 2 only: it may begin and end on others
};

/// The graphs of one sub-mesh, cheapest first.
struct SubMeshGraphs {
    std::optional<double> cost;       ///< of the best graph; none if no graph was found
    std::optional<double> lowerBound; ///< no graph is cheaper; equals cost when proven
    std::optional<std::string> count; ///< decimal number of motorcycle graphs, where it was asked for
    std::vector<MotorcycleGraph> graphs;
    std::vector<MotorcycleGraph> samples; ///< drawn uniformly, where that was asked for
};

/// Every `of`-th sub-mesh, beginning with `number` - 1: what one of several searches at the same time does.
struct Part {
    int number = 1;
    int of = 1;

    [[nodiscard]] bool holds(SubMeshId subMesh) const { return subMesh.value() % of == number - 1; }
    [[nodiscard]] bool isWhole() const { return of == 1; }
};

struct Enumeration {
    GraphCost cost;
    GraphClass graphClass = GraphClass::motorcycle;
    Method method = Method::optimum;
    std::optional<std::string> count; ///< product over the sub-meshes
    bool complete = true;             ///< no limit ended a search early
    Part part;                        ///< what was searched; nothing is known of the other sub-meshes
    IdVector<SubMeshId, SubMeshGraphs> subMeshes;
};

} // namespace qm
