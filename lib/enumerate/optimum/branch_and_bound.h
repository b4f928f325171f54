/// \file Branch and bound on one part of a search problem (docs/METHOD.md#optimum).
#pragma once

#include "base/infinity.h"
#include "enumerate/optimum/branching.h"
#include "enumerate/optimum/root_relaxation.h"
#include "enumerate/optimum/search_tree.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace qm {

/// Searches the free variables of one independent part; the rest of the state is left as it is.
class BranchAndBound {
public:
    /// \param state      consistent; the same after this object's life as before
    /// \param variables  the free variables of the part
    BranchAndBound(SearchState& state, std::vector<VariableId> variables, const PartOptions& options,
                   const Control& control);
    ~BranchAndBound() { part_.state.undo(origin_); }
    BranchAndBound(const BranchAndBound&) = delete;
    BranchAndBound& operator=(const BranchAndBound&) = delete;

    /// Offers a known graph to begin with; only its values of the part's variables count.
    void offer(const Assignment& assignment);
    /// Returns a graph that is at most as expensive; `relaxed` holds the values of the part's variables in
    /// their order.
    using Polish = std::function<Assignment(const Assignment& graph, const std::vector<double>& relaxed)>;
    /// What to call in a hard part after its relaxation.
    void polishWith(Polish polish) { polisher_ = std::move(polish); }
    /// Learns a lower bound, and says whether to go on.
    using Near = std::function<bool(double bound)>;
    /// What to call in a large part as soon as it is nearly relaxed, long before it is relaxed.
    void tellNear(Near near) { near_ = std::move(near); }
    void run();
    /// Searches on after `run` has come to the limit of nodes.
    void resume(std::size_t nodes);
    /// Ends the search with a graph that another one has proven to be the best.
    void conclude(const Assignment& best);

    /// Graphs as full assignments, of which only the part's variables mean anything.
    [[nodiscard]] const Incumbents& incumbents() const { return part_.incumbents; }
    [[nodiscard]] double lowerBound() const { return lowerBound_; }
    [[nodiscard]] bool complete() const { return complete_; }
    [[nodiscard]] std::size_t nodes() const { return nodes_; }
    [[nodiscard]] std::size_t work() const { return part_.work(); }
    /// After a search that is not complete: what is left to decide at the root, relaxed, or what is known of
    /// that by gradients. The bound may grow, and the search be complete after all.
    [[nodiscard]] std::optional<RelaxedProgram> relaxedRoot();
    /// Of the part's variables, in the relaxed solution of the root; empty if there was none.
    [[nodiscard]] const std::vector<double>& rootPresence() const { return root_.presence(); }

private:
    bool relaxNearly(double& bound);
    void search();
    void summarise();
    bool replay(SearchTree::NodeId node);
    void plunge(SearchTree::NodeId node, double bound);
    bool cutRoot(double& bound);
    bool lookAround(double& bound);
    bool comeBack(ColumnState::Mark mark, const Relaxation::Basis& basis, double& bound);
    void polish();

    SearchState::Mark origin_;
    PartSearch part_;
    Branching branching_;
    SearchTree tree_;
    RootRelaxation root_;
    double lowerBound_ = 0;
    bool complete_ = true;
    std::size_t nodes_ = 0;
    std::size_t nextLook_ = 1;
    Polish polisher_;
    Near near_;
    double polished_ = infinity; ///< cost of the last graph that was
};

} // namespace qm
