#include "enumerate/window/window_search.h"

#include "base/parallel.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/state/incumbents.h"
#include "enumerate/window/chain_links.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace qm {
namespace {

constexpr std::size_t batch = 8; ///< windows searched from the same graph, maybe at the same time

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

bool isValid(const Problem& problem, const Assignment& graph) {
    SearchState state(problem);
    if (!state.consistent()) return false;
    for (int v = 0; v < problem.variables(); ++v) {
        const ArcState wanted = graph[at(v)] == 1 ? ArcState::in : ArcState::out;
        if (state.isFree(v) ? !state.assign(v, wanted) : state.value(v) != wanted) return false;
    }
    return true;
}

class WindowSearch {
public:
    WindowSearch(const ProblemInput& input, const std::vector<bool>& present, const WindowOptions& options,
                 const Control& control)
        : whole_(makeProblem(input)), options_(options), control_(control), links_(whole_),
          changed_(whole_.chains.size(), 1), searched_(whole_.chains.size(), 0), nodes_(options.nodes) {
        result_.present = present;
        ProblemInput fixed = input;
        for (std::size_t arc = 0; arc < fixed.states.size(); ++arc)
            if (fixed.states[arc] == ArcState::free) fixed.states[arc] = stateOf(present[arc]);
        inputs_ = std::vector<ProblemInput>(batch, fixed);
    }

    WindowResult run() {
        std::size_t smallest = options_.minVariables;
        do {
            hard_ = 0;
            growWindows(smallest);
            smallest = hard_;
            nodes_ *= 4;
        } while (options_.patient && hard_ > 0 && !isOver());
        return std::move(result_);
    }

private:
    struct Window {
        int chain = 0;
        std::vector<int> chains;
        std::vector<bool> present; ///< empty unless it is cheaper
        bool complete = false;     ///< its search ended with a proof
    };

    [[nodiscard]] bool isOver() const {
        return result_.windows >= options_.maxWindows || control_.stopRequested();
    }

    /// Searches windows of one size, then of twice that size, and so on.
    void growWindows(std::size_t smallest) {
        const std::size_t max = std::min<std::size_t>(options_.maxVariables, at(whole_.variables()));
        for (size_ = std::min(smallest, max); !isOver(); size_ = std::min(2 * size_, max)) {
            std::ranges::fill(searched_, 0);
            while (pass() && !isOver()) {
            }
            if (size_ >= max) break;
        }
    }

    /// How much the graph and the relaxed solution disagree about every chain.
    [[nodiscard]] std::vector<double> disagreements() const {
        std::vector<double> sums(whole_.chains.size(), 1);
        if (options_.relaxed.empty()) return sums;
        constexpr double slight = 0.01; // of an arc: chains that agree follow last
        for (std::size_t c = 0; c < sums.size(); ++c) {
            sums[c] = slight * whole_.chains[c].count;
            forEachArc(static_cast<int>(c), [&](std::size_t arc) {
                sums[c] += std::abs(options_.relaxed[arc] - (result_.present[arc] ? 1 : 0));
            });
        }
        return sums;
    }

    /// Searches all windows of a size in which something has changed since.
    /// \return whether one improved
    bool pass() {
        const std::size_t before = result_.improvements;
        const std::vector<double> weights = disagreements();
        std::vector<int> order(whole_.chains.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, std::greater{}, [&](int chain) { return weights[at(chain)]; });
        std::vector<Window> windows;
        for (const int chain : order) {
            std::vector<int> chains = links_.cluster(chain, size_, weights);
            const bool stale =
                std::ranges::any_of(chains, [&](int c) { return changed_[at(c)] > searched_[at(chain)]; });
            if (stale) windows.push_back({chain, std::move(chains), {}, false});
            if (windows.size() == batch) searchBatch(windows);
            if (isOver()) return false;
        }
        searchBatch(windows);
        return result_.improvements > before;
    }

    void searchBatch(std::vector<Window>& windows) {
        parallelFor(windows.size(), control_.jobs, [&](std::size_t k) { search(windows[k], inputs_[k]); });
        ++clock_;
        const std::size_t before = result_.improvements;
        for (Window& window : windows) {
            ++result_.windows;
            if (!window.complete && hard_ == 0) hard_ = size_;
            searched_[at(window.chain)] = clock_;
            if (!window.present.empty()) accept(window, result_.improvements == before);
        }
        windows.clear();
    }

    /// The arcs of a chain are free in its windows.
    template <class Visit> void forEachArc(int chain, const Visit& visit) const {
        const Chain& c = whole_.chains[at(chain)];
        for (int v = c.first; v < c.first + c.count; ++v)
            for (int k = 0; k < whole_.arcs[at(v)].count; ++k)
                visit(at(whole_.arcs[at(v)].first.value() + k));
    }

    /// The search of a window: everything outside stays as it is, so that little of the mesh remains.
    /// \param input  where all is fixed; in the end it is so again
    [[nodiscard]] Problem problemOf(const Window& window, ProblemInput& input) const {
        input.lines.clear();
        for (const int chain : window.chains) {
            forEachArc(chain, [&](std::size_t arc) { input.states[arc] = ArcState::free; });
            const ArcId first = whole_.arcs[at(whole_.chains[at(chain)].first)].first;
            input.lines.push_back(input.graph.arcs[first.idx()].line);
        }
        std::ranges::sort(input.lines);
        input.lines.erase(std::unique(input.lines.begin(), input.lines.end()), input.lines.end());
        Problem problem = makeProblem(input);
        for (const int chain : window.chains)
            forEachArc(chain, [&](std::size_t arc) { input.states[arc] = stateOf(result_.present[arc]); });
        return problem;
    }

    static ArcState stateOf(bool present) { return present ? ArcState::in : ArcState::out; }

    void search(Window& window, ProblemInput& input) const {
        const Problem problem = problemOf(window, input);
        OptimumOptions options;
        options.start = assignmentOf(problem, result_.present);
        options.nodes = nodes_;
        const OptimumResult found = findOptimum(problem, options, control_);
        window.complete = found.complete;
        if (found.graphs.empty() ||
            costOf(problem, found.graphs.front()) >= costOf(problem, *options.start) - Incumbents::tolerance)
            return;
        window.present = result_.present;
        apply(problem, found.graphs.front(), window.present);
    }

    /// Takes the window's arcs over, unless an earlier window of the batch forbids it.
    void accept(const Window& window, bool first) {
        std::vector<bool> merged = result_.present;
        for (const int chain : window.chains)
            forEachArc(chain, [&](std::size_t arc) { merged[arc] = window.present[arc]; });
        if (!first && !improves(window, merged)) return;
        ++clock_;
        for (const int chain : window.chains) {
            bool same = true;
            forEachArc(chain, [&](std::size_t arc) { same = same && merged[arc] == result_.present[arc]; });
            if (same) continue;
            changed_[at(chain)] = clock_;
            for (const int neighbour : links_.neighbours(chain))
                changed_[at(neighbour)] = clock_;
        }
        result_.present = std::move(merged);
        for (const int chain : window.chains)
            forEachArc(chain, [&](std::size_t arc) {
                for (ProblemInput& input : inputs_)
                    input.states[arc] = stateOf(result_.present[arc]);
            });
        ++result_.improvements;
        options_.improved(result_.present);
    }

    /// Whether the window's arcs are valid and cheaper beside what has become of the others.
    [[nodiscard]] bool improves(const Window& window, const std::vector<bool>& merged) {
        const Problem problem = problemOf(window, inputs_.front());
        const Assignment graph = assignmentOf(problem, merged);
        return costOf(problem, graph) <
                   costOf(problem, assignmentOf(problem, result_.present)) - Incumbents::tolerance &&
               isValid(problem, graph);
    }

    const Problem whole_;
    const WindowOptions& options_;
    const Control& control_;
    ChainLinks links_;
    std::vector<std::size_t> changed_;  ///< when a chain or one that crosses it changed last
    std::vector<std::size_t> searched_; ///< when the window around a chain was searched last
    std::size_t clock_ = 1;
    std::size_t nodes_;
    std::size_t size_ = 0; ///< of the windows that are being searched
    std::size_t hard_ = 0; ///< the first size at which a search ended without a proof; 0 if none did
    WindowResult result_;
    std::vector<ProblemInput> inputs_; ///< of a batch's windows: everything fixed as in the result
};

} // namespace

WindowResult improveByWindows(const ProblemInput& input, const std::vector<bool>& present,
                              const WindowOptions& options, const Control& control) {
    return WindowSearch(input, present, options, control).run();
}

} // namespace qm
