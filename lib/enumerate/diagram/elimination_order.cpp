#include "enumerate/diagram/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr std::size_t maxStarts = 100;
constexpr double growth = 1.6;    ///< states that another open item brings, roughly
constexpr double hopeless = 1e15; ///< by that measure, which is far too high for wide borders

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// The crossings with something to decide, and the items that tie them: free variables, then open chains.
struct Ties {
    std::vector<std::vector<int>> itemsOf;     ///< of every crossing
    std::vector<std::vector<int>> crossingsOf; ///< of every item

    explicit Ties(const SearchState& state) {
        const Problem& problem = state.problem();
        const int variables = static_cast<int>(problem.domains.size());
        itemsOf.resize(problem.crossings.size());
        crossingsOf.resize(problem.domains.size() + problem.chains.size());
        for (std::size_t c = 0; c < problem.crossings.size(); ++c)
            for (const CrossingSide& side : problem.crossings[c].sides) {
                for (const int variable : {side.before, side.after})
                    if (state.isFree(variable)) add(static_cast<int>(c), variable);
                const int chain = side.node < 0 ? -1 : problem.nodes[at(side.node)].chain;
                if (problem.gaps && chain >= 0 && state.coverOfChain(chain) == Cover::open)
                    add(static_cast<int>(c), variables + chain);
            }
    }

private:
    void add(int crossing, int item) {
        std::vector<int>& items = itemsOf[at(crossing)];
        if (std::ranges::find(items, item) != items.end()) return;
        items.push_back(item);
        crossingsOf[at(item)].push_back(crossing);
    }
};

/// Grows an order of crossings from a start and adds up what it costs.
class Sweep {
public:
    explicit Sweep(const Ties& ties)
        : ties_(ties), done_(ties.crossingsOf.size()), state_(ties.itemsOf.size(), Seen::no) {}

    /// \return the cost, or infinity once it reaches `limit`
    double run(int start, double limit, std::vector<int>& order) {
        std::ranges::fill(done_, 0);
        std::ranges::fill(state_, Seen::no);
        order.clear();
        std::vector<int> border{start};
        int open = 0;
        double cost = 0;
        while (!border.empty()) {
            const auto next = std::ranges::min_element(
                border, {}, [this](int crossing) { return std::pair(change(crossing), crossing); });
            const int crossing = *next;
            border.erase(next);
            open += change(crossing);
            take(crossing, border);
            order.push_back(crossing);
            cost += std::pow(growth, open);
            if (cost >= limit) return std::numeric_limits<double>::infinity();
        }
        return cost;
    }

private:
    enum class Seen : char { no, border, done };

    /// By how much the number of open items grows.
    [[nodiscard]] int change(int crossing) const {
        int sum = 0;
        for (const int item : ties_.itemsOf[at(crossing)]) {
            const int all = static_cast<int>(ties_.crossingsOf[at(item)].size());
            const int before = done_[at(item)], after = before + 1;
            sum += (after < all ? 1 : 0) - (before > 0 && before < all ? 1 : 0);
        }
        return sum;
    }

    void take(int crossing, std::vector<int>& border) {
        state_[at(crossing)] = Seen::done;
        for (const int item : ties_.itemsOf[at(crossing)]) {
            ++done_[at(item)];
            for (const int other : ties_.crossingsOf[at(item)]) {
                if (state_[at(other)] != Seen::no) continue;
                state_[at(other)] = Seen::border;
                border.push_back(other);
            }
        }
    }

    const Ties& ties_;
    std::vector<int> done_; ///< crossings of every item that the sweep has passed
    std::vector<Seen> state_;
};

/// All crossings of the connected part that one belongs to.
std::vector<int> partOf(const Ties& ties, int first, std::vector<bool>& seen) {
    std::vector<int> part{first};
    seen[at(first)] = true;
    for (std::size_t next = 0; next < part.size(); ++next)
        for (const int item : ties.itemsOf[at(part[next])])
            for (const int other : ties.crossingsOf[at(item)]) {
                if (seen[at(other)]) continue;
                seen[at(other)] = true;
                part.push_back(other);
            }
    return part;
}

/// The crossings, part by part, each part in the order of its best sweep.
/// \return nothing if the sweeps of a part are all hopeless, or `control.stopRequested`
std::optional<std::vector<int>> crossingOrder(const Ties& ties, const Control& control) {
    Sweep sweep(ties);
    std::vector<bool> seen(ties.itemsOf.size(), false);
    std::vector<int> order, tried, best;
    for (int first = 0; first < static_cast<int>(ties.itemsOf.size()); ++first) {
        if (seen[at(first)]) continue;
        const std::vector<int> part = partOf(ties, first, seen);
        const std::size_t stride = 1 + part.size() / maxStarts;
        double minCost = hopeless;
        for (std::size_t k = 0; k < part.size(); k += stride) {
            if (control.stopRequested()) return std::nullopt;
            const double cost = sweep.run(part[k], minCost, tried);
            if (cost >= minCost) continue;
            minCost = cost;
            best.swap(tried);
        }
        if (minCost == hopeless) return std::nullopt;
        order.insert(order.end(), best.begin(), best.end());
    }
    return order;
}

} // namespace

std::optional<std::vector<Step>> eliminationOrder(const SearchState& state, const Control& control) {
    const Ties ties(state);
    const int variables = static_cast<int>(state.problem().domains.size());
    std::vector<bool> placed(at(variables), false);
    std::vector<Step> steps;
    const auto place = [&](int variable) {
        if (!placed[at(variable)]) steps.push_back({variable, -1, -1});
        placed[at(variable)] = true;
    };
    const auto order = crossingOrder(ties, control);
    if (!order) return std::nullopt;
    for (const int crossing : *order) {
        const std::vector<int>& items = ties.itemsOf[at(crossing)];
        for (const int item : items)
            if (item < variables) place(item);
        for (const int item : items)
            if (item >= variables) steps.push_back({-1, item - variables, crossing});
    }
    for (int variable = 0; variable < state.problem().variables(); ++variable)
        if (state.isFree(variable)) place(variable);
    return steps;
}

} // namespace qm
