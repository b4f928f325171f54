#include "enumerate/window/window_search.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/state/incumbents.h"
#include "enumerate/window/chain_links.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace qm {
namespace {

struct Tuning {
    /// Windows searched from the same graph, possibly in parallel. A constant, so that the result does not
    /// depend on the number of threads; more would waste searches on a graph that is no longer the best.
    static constexpr std::size_t batch = 8;
    /// In a patient search, the limit of trees grows by this factor when no window of any size helps.
    static constexpr std::size_t growthOfTrees = 4;
    /// Added to a chain's disagreement for every arc, so that windows grow by chains without disagreement,
    /// too, by long ones first.
    static constexpr double slight = 0.01;
    /// Less disagreement is rounding of the relaxed solution.
    static constexpr double agreement = 1e-3;
};

/// A number for the chains of a window, because large windows would take much memory. Should two windows have
/// the same number, one of them may be passed over, which does no harm.
/// \param chains  ascending
std::uint64_t keyOf(const std::vector<ChainId>& chains) {
    std::uint64_t key = chains.size();
    for (const ChainId chain : chains)
        key = (key ^ std::hash<ChainId>{}(chain)) * 0x9e3779b97f4a7c15ULL;
    return key;
}

bool isValid(const Problem& problem, const Assignment& graph) {
    SearchState state(problem);
    return state.consistent() && std::ranges::all_of(problem.variables(), [&](VariableId variable) {
               return state.assign(variable, arcState(graph[variable] == 1));
           });
}

/// Whether arcs form a valid graph that is cheaper than another one. Arcs that share a variable may differ,
/// because they were found in a problem in which they did not share it; then they are no graph.
bool improves(const Problem& problem, const Assignment& before, const PresentArcs& present) {
    const Assignment graph = assignmentOf(problem, present);
    return costOf(problem, graph) < costOf(problem, before) - Incumbents::tolerance &&
           differences(problem, graph, present).empty() && isValid(problem, graph);
}

class WindowSearch {
public:
    WindowSearch(const ProblemInput& input, const PresentArcs& present, const WindowOptions& options,
                 const Control& control)
        : input_(input), whole_(makeProblem(input)), options_(options), control_(control), links_(whole_),
          changed_(whole_.chains.size(), 1), searched_(whole_.chains.size(), 0), nodes_(options.nodes) {
        result_.present = present;
    }

    WindowResult run() {
        std::size_t smallest = options_.minVariables;
        do {
            hard_.reset();
            growWindows(smallest);
            smallest = hard_.value_or(smallest);
            nodes_ *= Tuning::growthOfTrees;
        } while (options_.patient && hard_ && !isOver());
        return std::move(result_);
    }

private:
    struct ArcValue {
        ArcId arc;
        bool present;
    };

    struct Window {
        ChainId chain;
        std::vector<ChainId> chains;  ///< ascending
        std::vector<ArcValue> values; ///< new values of its arcs; empty unless a cheaper graph was found
        bool complete = false;        ///< whether the search ended with a proof
        std::size_t work = 0;         ///< of the search
    };

    [[nodiscard]] bool isOver() const {
        return result_.windows >= options_.maxWindows || work_ >= options_.maxWork ||
               control_.stopRequested();
    }

    /// Searches windows of one size until none helps, then of twice the size, and so on.
    void growWindows(std::size_t smallest) {
        const std::size_t max = std::min<std::size_t>(options_.maxVariables, whole_.arcs.size());
        for (size_ = std::min(smallest, max); !isOver(); size_ = std::min(2 * size_, max)) {
            if (options_.alongTracks) links_ = ChainLinks(whole_, assignmentOf(whole_, result_.present));
            std::ranges::fill(searched_, 0);
            searchedTogether_.clear();
            while (pass() && !isOver()) {
            }
            if (size_ >= max) break;
        }
    }

    /// For every chain, how much the graph and the relaxed solution disagree.
    [[nodiscard]] IdVector<ChainId, double> disagreements() const {
        IdVector<ChainId, double> sums(whole_.chains.size(), 1);
        if (options_.relaxed.empty()) return sums;
        for (const ChainId c : sums.ids()) {
            sums[c] = Tuning::slight * whole_.chains[c].count;
            forEachArc(c, [&](ArcId arc) {
                sums[c] += std::abs(options_.relaxed[arc] - (result_.present[arc] ? 1 : 0));
            });
        }
        return sums;
    }

    /// Whether a chain begins a window: where the graph is as in the relaxed solution, few windows help.
    [[nodiscard]] bool isDoubtful(ChainId chain, double disagreement) const {
        return options_.relaxed.empty() ||
               disagreement > Tuning::slight * whole_.chains[chain].count + Tuning::agreement;
    }

    /// Searches all windows of the current size that have changed since their last search.
    /// \return whether a window improved the graph
    bool pass() {
        const std::size_t before = result_.improvements;
        const IdVector<ChainId, double> weights = disagreements();
        std::vector<ChainId> order;
        for (const ChainId chain : whole_.chains.ids())
            if (isDoubtful(chain, weights[chain])) order.push_back(chain);
        std::ranges::stable_sort(order, std::greater{}, [&](ChainId chain) { return weights[chain]; });
        std::vector<Window> windows;
        for (const ChainId chain : order) {
            if (lastChange_ <= searched_[chain]) continue; // its cluster need not be grown to know that
            std::vector<ChainId> chains = links_.cluster(chain, size_, weights);
            std::ranges::sort(chains);
            std::size_t& together = searchedTogether_[keyOf(chains)]; // many grow to the same window
            const std::size_t last = std::max(searched_[chain], together);
            if (std::ranges::any_of(chains, [&](ChainId c) { return changed_[c] > last; })) {
                together = clock_ + 1; // when the batch will have been searched
                windows.push_back({chain, std::move(chains), {}, false, 0});
            }
            if (windows.size() == Tuning::batch) searchBatch(windows);
            if (isOver()) return false;
        }
        searchBatch(windows);
        return result_.improvements > before;
    }

    void searchBatch(std::vector<Window>& windows) {
        parallelFor(windows.size(), control_.jobs, [&](std::size_t k) { search(windows[k]); });
        const std::size_t time = ++clock_; // all were searched before any of them changes the graph
        const std::size_t before = result_.improvements;
        for (Window& window : windows) {
            ++result_.windows;
            work_ += window.work;
            if (!window.complete && !hard_) hard_ = size_;
            searched_[window.chain] = time;
            if (!window.values.empty()) accept(window, result_.improvements == before);
        }
        windows.clear();
        control_.progress(static_cast<double>(result_.windows) / static_cast<double>(options_.maxWindows));
    }

    /// Visits all arcs of a chain.
    template <class Visit> void forEachArc(ChainId chain, const Visit& visit) const {
        for (const VariableId v : whole_.chains[chain].variables())
            for (const ArcId arc : whole_.arcs[v].arcs())
                visit(arc);
    }

    /// The problem of a window; everything outside is fixed, so the problem is small.
    [[nodiscard]] Problem problemOf(const Window& window) const {
        std::vector<ArcId> arcs;
        std::vector<LineId> lines;
        for (const ChainId chain : window.chains) {
            forEachArc(chain, [&](ArcId arc) { arcs.push_back(arc); });
            lines.push_back(input_.graph.arcs[arcs.back()].line);
        }
        sortUnique(lines);
        return makeProblem({input_.graph, input_.arcCosts, ArcStates(result_.present, arcs), input_.demands,
                            input_.open, input_.walkers, input_.cornerCost, std::move(lines)});
    }

    void setSearched(const Window& window, std::size_t time) {
        searched_[window.chain] = searchedTogether_[keyOf(window.chains)] = time;
    }

    void search(Window& window) const {
        const Problem problem = problemOf(window);
        OptimumOptions options;
        options.start = assignmentOf(problem, result_.present);
        options.nodes = nodes_;
        options.work = options_.work;
        const OptimumResult found = findOptimum(problem, options, control_);
        window.complete = found.complete;
        window.work = found.work;
        if (found.graphs.empty() ||
            costOf(problem, found.graphs.front()) >= costOf(problem, *options.start) - Incumbents::tolerance)
            return;
        for (const VariableId v : problem.variables())
            for (const ArcId arc : problem.arcs[v].arcs())
                window.values.push_back({arc, found.graphs.front()[v] == 1});
    }

    /// Adopts the window's new values, unless those of an earlier window of the batch rule them out.
    void accept(const Window& window, bool first) {
        std::unordered_set<ArcId> changes;
        for (const ArcValue& value : window.values)
            if (result_.present[value.arc] != value.present) changes.insert(value.arc);
        const auto change = [&] {
            for (const ArcId arc : changes)
                result_.present[arc].flip();
        };
        if (first) {
            change();
        } else {
            const Problem problem = problemOf(window);
            const Assignment before = assignmentOf(problem, result_.present);
            change();
            if (!improves(problem, before, result_.present)) {
                setSearched(window, 0); // it may have others now
                return change();
            }
        }
        ++clock_;
        if (first && window.complete) setSearched(window, clock_); // nothing better until others change
        for (const ChainId chain : window.chains) {
            bool same = true;
            forEachArc(chain, [&](ArcId arc) { same = same && !changes.contains(arc); });
            if (same) continue;
            lastChange_ = changed_[chain] = clock_;
            for (const ChainId neighbour : links_.neighbours(chain))
                changed_[neighbour] = clock_;
        }
        ++result_.improvements;
        options_.improved(result_.present);
    }

    const ProblemInput& input_;
    const Problem whole_;
    const WindowOptions& options_;
    const Control& control_;
    ChainLinks links_;
    IdVector<ChainId, std::size_t> changed_;  ///< last time at which a chain or one linked to it changed
    IdVector<ChainId, std::size_t> searched_; ///< last time at which the window around a chain was searched
    std::unordered_map<std::uint64_t, std::size_t>
        searchedTogether_;       ///< the same by the key of a window's chains
    std::size_t lastChange_ = 1; ///< of any chain
    std::size_t clock_ = 1;
    std::size_t nodes_;
    std::size_t work_ = 0;            ///< of all windows so far
    std::size_t size_ = 0;            ///< of the windows being searched
    std::optional<std::size_t> hard_; ///< the first window size at which a search ended without a proof
    WindowResult result_;
};

} // namespace

WindowResult improveByWindows(const ProblemInput& input, const PresentArcs& present,
                              const WindowOptions& options, const Control& control) {
    return WindowSearch(input, present, options, control).run();
}

} // namespace qm
