/// \file The result of a search: the graphs of every sub-mesh (docs/METHOD.md#sub-meshes).
#pragma once

#include "base/id_vector.h"
#include "layout/cost.h"
#include "layout/motorcycle_graph.h"

#include <optional>
#include <string>
#include <vector>

namespace qm {

enum class Method {
    optimum,  ///< branch and bound; the best graphs and a lower bound
    naive,    ///< the paper's: all coordinate vectors, filtered (docs/METHOD.md#coordinate-search)
    bounds,   ///< the paper's: rules B1 to B4
    improved, ///< the paper's: rules B1 to B3 and B4'
    plain     ///< the plain motorcycle graph (docs/METHOD.md#plain-graph)
};

/// Which tracks are allowed.
enum class GraphClass {
    motorcycle, ///< rules 1 to 4: every track begins at a source
    tmesh       ///< rules 1 and 2 only: tracks may also begin and end on other tracks
};

/// The graphs of one sub-mesh, cheapest first.
struct SubMeshGraphs {
    std::optional<double> cost;       ///< of the best graph; none if no graph was found
    std::optional<double> lowerBound; ///< no graph is cheaper; equal to `cost` if that is proven optimal
    std::optional<std::string> count; ///< number of motorcycle graphs in decimal, if asked for
    std::vector<MotorcycleGraph> graphs;
    std::vector<MotorcycleGraph> samples; ///< drawn uniformly, if asked for
};

/// Every `of`-th sub-mesh, beginning with `number` - 1: one share of a search that is divided among
/// processes.
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
    std::optional<std::string> count; ///< product over all sub-meshes
    bool complete = true;             ///< false if a limit ended a search early
    Part part; ///< the sub-meshes that were searched; nothing is known about the others
    IdVector<SubMeshId, SubMeshGraphs> subMeshes;
};

} // namespace qm
