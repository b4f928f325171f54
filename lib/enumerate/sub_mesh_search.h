/// \file The search of one sub-mesh after another: from options to graphs.
#pragma once

#include "enumerate/enumerate.h"
#include "enumerate/graph_pipeline.h"
#include "enumerate/sub_mesh/search_space.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace qm {

class SubMeshSearch {
public:
    /// All arguments outlive this.
    SubMeshSearch(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& edgeCosts,
                  const SubMeshes& subMeshes, const EnumerationOptions& options);

    /// What the options ask for. `complete` becomes false if a limit ended it early.
    [[nodiscard]] SubMeshGraphs search(SubMeshId subMesh, const Control& control,
                                       std::atomic<bool>& complete) const;

    /// Lists every graph; ranked, the cheapest first and as many as are to be kept.
    /// \return false if `listing` or a limit ended it early
    bool list(SubMeshId subMesh, bool ranked, const GraphListing& listing, const Control& control) const;

private:
    struct Task {
        SubMeshId subMesh;
        std::shared_ptr<const SearchSpace> space; ///< where its own particles walk
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

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const std::vector<double>& edgeCosts_;
    const EnumerationOptions& options_;
    SearchSpace space_;
    IdVector<SubMeshId, double> sureCosts_; ///< of every sub-mesh: of the corners that all graphs have
};

} // namespace qm
