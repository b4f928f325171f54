/// \file The search of single sub-meshes as the options ask for it.
#pragma once

#include "enumerate/enumerate.h"
#include "enumerate/state/assignment.h"
#include "enumerate/sub_mesh/search_space.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace qm {

class SubMeshSearch {
public:
    /// All arguments must outlive this.
    SubMeshSearch(const SearchedMesh& searched, const std::vector<double>& edgeCosts,
                  const EnumerationOptions& options);

    /// Finds what the options ask for. Sets `complete` to false if a limit ended the search early.
    [[nodiscard]] SubMeshGraphs search(SubMeshId subMesh, const Control& control,
                                       std::atomic<bool>& complete) const;

    /// \return false if `listing` or a limit ended the list early
    bool list(SubMeshId subMesh, ListedGraphs which, const GraphListing& listing,
              const Control& control) const;

private:
    struct Task {
        SubMeshId subMesh;
        std::shared_ptr<const SearchSpace> space; ///< the lines of the sub-mesh's own particles
        Problem problem;
        Walkers walkers;
    };

    [[nodiscard]] Task task(SubMeshId subMesh) const;
    [[nodiscard]] double maxCost(SubMeshId subMesh) const;
    [[nodiscard]] MotorcycleGraph graph(const Task& task, const Assignment& assignment) const;
    [[nodiscard]] std::optional<Assignment> simpleGraph(const Task& task) const;
    [[nodiscard]] SubMeshGraphs searchOptimum(const Task& task, const Control& control,
                                              std::atomic<bool>& complete) const;
    [[nodiscard]] SubMeshGraphs searchCoordinates(const Task& task, const Control& control,
                                                  std::atomic<bool>& complete) const;
    void countAndDraw(const Task& task, SubMeshGraphs& result, const Control& control,
                      std::atomic<bool>& complete) const;
    bool find(const Task& task, const std::function<bool(const Assignment&)>& visit,
              const Control& control) const;
    bool findRanked(const Task& task, const std::function<bool(const Assignment&)>& visit,
                    const Control& control) const;

    const SearchedMesh& searched_;
    const std::vector<double>& edgeCosts_;
    const EnumerationOptions& options_;
    SearchSpace space_;
    IdVector<SubMeshId, double> fixedCosts_; ///< of the corners that all graphs of a sub-mesh have
};

} // namespace qm
