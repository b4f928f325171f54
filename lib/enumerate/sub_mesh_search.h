/// \file The search of single sub-meshes as the options ask for it.
#pragma once

#include "enumerate/enumerate.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/sub_mesh/search_space.h"

#include <functional>

namespace qm {

class SubMeshSearch {
public:
    /// All arguments must outlive this.
    SubMeshSearch(const SearchedMesh& searched, const EnumerationOptions& options);

    struct Found {
        SubMeshGraphs subMesh;
        bool complete = true; ///< false if a limit ended the search early
    };

    /// Finds what the options ask for.
    /// \throw Error  if the constraints leave no graph
    [[nodiscard]] Found search(SubMeshId subMesh, const Control& control) const;

    /// \return false if `listing` or a limit ended the list early
    bool list(SubMeshId subMesh, ListedGraphs which, const GraphListing& listing,
              const Control& control) const;

private:
    struct Task {
        SubMeshId subMesh;
        SearchSpace space; ///< the lines of the sub-mesh's own particles
        Problem problem;
        Walkers walkers;
    };

    [[nodiscard]] Task task(SubMeshId subMesh) const;
    [[nodiscard]] double maxCost(SubMeshId subMesh) const;
    [[nodiscard]] MotorcycleGraph graph(const Task& task, const Assignment& assignment) const;
    [[nodiscard]] OptimumOptions optimumOptions(const Task& task) const;
    [[nodiscard]] Found searchOptimum(const Task& task, const Control& control) const;
    [[nodiscard]] Found searchCoordinates(const Task& task, const Control& control) const;
    void countAndDraw(const Task& task, Found& found, const Control& control) const;
    bool find(const Task& task, const std::function<bool(const Assignment&)>& visit,
              const Control& control) const;
    bool findRanked(const Task& task, const std::function<bool(const Assignment&)>& visit,
                    const Control& control) const;

    const SearchedMesh& searched_;
    const EnumerationOptions& options_;
    const std::vector<double> edgeCosts_;
    SearchSpace space_;
    IdVector<SubMeshId, double> fixedCosts_; ///< of the corners that all graphs of a sub-mesh have
};

} // namespace qm
