/// \file The search of one sub-mesh after another: from options to graphs.
#pragma once

#include "enumerate/enumerate.h"
#include "enumerate/search_space.h"

#include <atomic>
#include <functional>
#include <optional>

namespace qm {

class SubMeshSearch {
public:
    /// All arguments outlive this.
    SubMeshSearch(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& edgeCosts,
                  const SubMeshes& subMeshes, const EnumerationOptions& options);

    /// What the options ask for. `complete` becomes false if a limit ended it early.
    [[nodiscard]] SubMeshGraphs search(int subMesh, const Control& control,
                                       std::atomic<bool>& complete) const;

    /// Hands over every graph; ranked, the cheapest first and as many as are to be kept.
    /// \return false if `visit` or a limit ended it early
    using Visit = std::function<bool(const MotorcycleGraph&)>;
    bool forEach(int subMesh, bool ranked, const Visit& visit, const Control& control) const;

private:
    [[nodiscard]] Problem problem(int subMesh) const;
    [[nodiscard]] double maxCost(int subMesh) const;
    [[nodiscard]] MotorcycleGraph graph(const Problem& problem, int subMesh,
                                        const Assignment& assignment) const;
    [[nodiscard]] std::optional<Assignment> simpleGraph(const Problem& problem, int subMesh) const;
    [[nodiscard]] SubMeshGraphs searchOptimum(const Problem& problem, int subMesh, const Control& control,
                                              std::atomic<bool>& complete) const;
    [[nodiscard]] SubMeshGraphs searchCoordinates(const Problem& problem, int subMesh, const Control& control,
                                                  std::atomic<bool>& complete) const;
    void countAndDraw(const Problem& problem, int subMesh, SubMeshGraphs& result, const Control& control,
                      std::atomic<bool>& complete) const;

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const std::vector<double>& edgeCosts_;
    const EnumerationOptions& options_;
    SearchSpace space_;
    std::vector<double> sureCosts_; ///< of every sub-mesh: of the corners that all graphs have
};

} // namespace qm
