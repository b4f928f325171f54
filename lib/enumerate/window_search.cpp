#include "enumerate/window_search.h"

#include "base/parallel.h"
#include "enumerate/chain_links.h"
#include "enumerate/incumbents.h"
#include "enumerate/optimum.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace qm {
namespace {

constexpr std::size_t batch = 8; ///< windows searched from the same graph, maybe at the same time

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

class WindowSearch {
public:
    WindowSearch(const Problem& problem, const Assignment& start, const WindowOptions& options,
                 const Control& control)
        : problem_(problem), options_(options), control_(control), links_(problem),
          changed_(problem.chains.size(), 1), searched_(problem.chains.size(), 0) {
        result_.graph = start;
        result_.cost = costOf(problem, start);
        for (std::size_t k = 0; k < batch; ++k)
            states_.push_back(std::make_unique<SearchState>(problem));
    }

    WindowResult run() {
        if (!states_.front()->consistent()) return std::move(result_);
        const std::size_t most = std::min<std::size_t>(options_.mostVariables, at(problem_.variables()));
        for (std::size_t size = options_.leastVariables; !control_.stopRequested(); size *= 2) {
            std::ranges::fill(searched_, 0);
            while (pass(size) && !control_.stopRequested()) {
            }
            if (size >= most) break;
        }
        return std::move(result_);
    }

private:
    struct Window {
        int chain = 0;
        std::vector<int> chains;
        Assignment graph; ///< empty unless it is cheaper
    };

    /// Searches all windows of a size in which something has changed since. \return whether one improved
    bool pass(std::size_t size) {
        const std::size_t before = result_.improvements;
        std::vector<Window> windows;
        for (int chain = 0; chain < static_cast<int>(problem_.chains.size()); ++chain) {
            std::vector<int> chains = links_.cluster(chain, size);
            const bool stale =
                std::ranges::any_of(chains, [&](int c) { return changed_[at(c)] > searched_[at(chain)]; });
            if (stale) windows.push_back({chain, std::move(chains), {}});
            if (windows.size() == batch) searchBatch(windows);
            if (control_.stopRequested()) return false;
        }
        searchBatch(windows);
        return result_.improvements > before;
    }

    void searchBatch(std::vector<Window>& windows) {
        parallelFor(windows.size(), control_.jobs, [&](std::size_t k) { search(*states_[k], windows[k]); });
        ++clock_;
        for (Window& window : windows) {
            ++result_.windows;
            searched_[at(window.chain)] = clock_;
            if (!window.graph.empty()) accept(window);
        }
        windows.clear();
    }

    void search(SearchState& state, Window& window) const {
        const SearchState::Mark mark = state.mark();
        if (fixOutside(state, window.chains, result_.graph)) {
            OptimumOptions options;
            options.start = result_.graph;
            options.nodes = options_.nodes;
            const OptimumResult found = findOptimum(state, options, control_);
            if (!found.graphs.empty() &&
                costOf(problem_, found.graphs.front()) < result_.cost - Incumbents::tolerance)
                window.graph = found.graphs.front();
        }
        state.undo(mark);
    }

    /// Everything that is not in the window stays as it is in the graph.
    bool fixOutside(SearchState& state, const std::vector<int>& chains, const Assignment& graph) const {
        std::vector<bool> inside(problem_.chains.size(), false);
        for (const int chain : chains)
            inside[at(chain)] = true;
        for (int v = 0; v < problem_.variables(); ++v)
            if (!inside[at(state.chainOf(v))] && !agree(state, v, graph)) return false;
        return true;
    }

    static bool agree(SearchState& state, int variable, const Assignment& graph) {
        const ArcState wanted = graph[at(variable)] == 1 ? ArcState::in : ArcState::out;
        if (!state.isFree(variable)) return state.value(variable) == wanted;
        return state.assign(variable, wanted);
    }

    /// Takes the window's arcs over, unless an earlier window of the batch forbids it.
    void accept(const Window& window) {
        Assignment merged = result_.graph;
        std::vector<int> different;
        for (const int c : window.chains) {
            const Chain& chain = problem_.chains[at(c)];
            for (int v = chain.first; v < chain.first + chain.count; ++v)
                merged[at(v)] = window.graph[at(v)];
        }
        const double cost = costOf(problem_, merged);
        if (cost >= result_.cost - Incumbents::tolerance || !isValid(merged)) return;
        ++clock_;
        for (const int c : window.chains) {
            const Chain& chain = problem_.chains[at(c)];
            const auto span = [&](const Assignment& graph) { return graph.begin() + chain.first; };
            if (!std::equal(span(merged), span(merged) + chain.count, span(result_.graph)))
                for (const int neighbour : links_.neighbours(c))
                    changed_[at(neighbour)] = clock_;
            changed_[at(c)] = std::max(changed_[at(c)], changed_[at(c)]);
        }
        result_.graph = std::move(merged);
        result_.cost = cost;
        ++result_.improvements;
    }

    bool isValid(const Assignment& graph) const {
        SearchState& state = *states_.front();
        const SearchState::Mark mark = state.mark();
        bool valid = true;
        for (int v = 0; v < problem_.variables() && valid; ++v)
            valid = agree(state, v, graph);
        state.undo(mark);
        return valid;
    }

    const Problem& problem_;
    const WindowOptions& options_;
    const Control& control_;
    ChainLinks links_;
    std::vector<std::unique_ptr<SearchState>> states_;
    std::vector<std::size_t> changed_;  ///< when a chain or one that crosses it changed last
    std::vector<std::size_t> searched_; ///< when the window around a chain was searched last
    std::size_t clock_ = 1;
    WindowResult result_;
};

} // namespace

WindowResult improveByWindows(const Problem& problem, const Assignment& start, const WindowOptions& options,
                              const Control& control) {
    return WindowSearch(problem, start, options, control).run();
}

} // namespace qm
