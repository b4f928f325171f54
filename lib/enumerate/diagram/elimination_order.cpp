#include "enumerate/diagram/elimination_order.h"

#include "base/infinity.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

struct Tuning {
    /// Starting points tried per connected part: the best of so many is seldom far from the best of all.
    static constexpr std::size_t maxStarts = 100;
    /// Factor by which each open item multiplies the states of a border, roughly; below 2, as rules forbid
    /// some.
    static constexpr double growth = 1.6;
    /// An order with more estimated states than this is not worth following. The estimate is far too high for
    /// wide borders, so the limit is far above what fits into memory.
    static constexpr double hopeless = 1e15;
};

/// Something that ties crossings: a free variable, or a chain whose cover is open (numbered after these).
using ItemId = Id<struct ItemTag>;

/// The items at every crossing, and the crossings of every item.
struct Ties {
    IdVector<CrossingId, std::vector<ItemId>> itemsOf;
    IdVector<ItemId, std::vector<CrossingId>> crossingsOf;

    explicit Ties(const SearchState& state) {
        const Problem& problem = state.problem();
        chains_ = problem.domains.nextId().value();
        itemsOf.resize(problem.crossings.size());
        crossingsOf.resize(problem.domains.size() + problem.chains.size());
        for (const CrossingId crossing : problem.crossings.ids())
            for (const CrossingSide& side : problem.crossings[crossing].sides) {
                for (const VariableId variable : {side.before, side.after})
                    if (state.isFree(variable)) add(crossing, ItemId(variable.value()));
                const ChainId chain = side.node.valid() ? problem.nodes[side.node].chain : ChainId();
                if (problem.gaps && chain.valid() && state.coverOfChain(chain) == Cover::open)
                    add(crossing, ItemId(chains_ + chain.value()));
            }
    }

    /// The variable or the chain that an item stands for; the other id of the pair is none.
    [[nodiscard]] std::pair<VariableId, ChainId> meaning(ItemId item) const {
        if (item.value() < chains_) return {VariableId(item.value()), {}};
        return {{}, ChainId(item.value() - chains_)};
    }

private:
    void add(CrossingId crossing, ItemId item) {
        std::vector<ItemId>& items = itemsOf[crossing];
        if (std::ranges::find(items, item) != items.end()) return;
        items.push_back(item);
        crossingsOf[item].push_back(crossing);
    }

    int chains_ = 0; ///< the first item that is a chain
};

/// Grows an order of crossings from a starting point, and sums up the estimated states.
class Sweep {
public:
    explicit Sweep(const Ties& ties)
        : ties_(ties), done_(ties.crossingsOf.size()), state_(ties.itemsOf.size(), Seen::no) {}

    /// \return the estimate, or infinity once it reaches `limit`
    double run(CrossingId start, double limit, std::vector<CrossingId>& order) {
        std::ranges::fill(done_, 0);
        std::ranges::fill(state_, Seen::no);
        order.clear();
        std::vector<CrossingId> border{start};
        int open = 0;
        double cost = 0;
        while (!border.empty()) {
            const auto next = std::ranges::min_element(
                border, {}, [this](CrossingId crossing) { return std::pair(change(crossing), crossing); });
            const CrossingId crossing = *next;
            border.erase(next);
            open += change(crossing);
            take(crossing, border);
            order.push_back(crossing);
            cost += std::pow(Tuning::growth, open);
            if (cost >= limit) return infinity;
        }
        return cost;
    }

private:
    enum class Seen : char { no, border, done };

    /// The change of the number of open items if this crossing came next.
    [[nodiscard]] int change(CrossingId crossing) const {
        int sum = 0;
        for (const ItemId item : ties_.itemsOf[crossing]) {
            const int all = static_cast<int>(ties_.crossingsOf[item].size());
            const int before = done_[item], after = before + 1;
            sum += (after < all ? 1 : 0) - (before > 0 && before < all ? 1 : 0);
        }
        return sum;
    }

    void take(CrossingId crossing, std::vector<CrossingId>& border) {
        state_[crossing] = Seen::done;
        for (const ItemId item : ties_.itemsOf[crossing]) {
            ++done_[item];
            for (const CrossingId other : ties_.crossingsOf[item]) {
                if (state_[other] != Seen::no) continue;
                state_[other] = Seen::border;
                border.push_back(other);
            }
        }
    }

    const Ties& ties_;
    IdVector<ItemId, int> done_; ///< for every item, its crossings that are in the order already
    IdVector<CrossingId, Seen> state_;
};

/// All crossings of the connected part that contains the first one.
std::vector<CrossingId> partOf(const Ties& ties, CrossingId first, IdVector<CrossingId, bool>& seen) {
    std::vector<CrossingId> part{first};
    seen[first] = true;
    for (std::size_t next = 0; next < part.size(); ++next)
        for (const ItemId item : ties.itemsOf[part[next]])
            for (const CrossingId other : ties.crossingsOf[item]) {
                if (seen[other]) continue;
                seen[other] = true;
                part.push_back(other);
            }
    return part;
}

/// All crossings, part by part, each part in the order of its best sweep.
/// \return nothing if all sweeps of some part are hopeless, or if `control.stopRequested`
std::optional<std::vector<CrossingId>> crossingOrder(const Ties& ties, const Control& control) {
    Sweep sweep(ties);
    IdVector<CrossingId, bool> seen(ties.itemsOf.size(), false);
    std::vector<CrossingId> order, tried, best;
    for (const CrossingId first : ties.itemsOf.ids()) {
        if (seen[first]) continue;
        const std::vector<CrossingId> part = partOf(ties, first, seen);
        const std::size_t stride = 1 + part.size() / Tuning::maxStarts;
        double minCost = Tuning::hopeless;
        for (std::size_t k = 0; k < part.size(); k += stride) {
            if (control.stopRequested()) return std::nullopt;
            const double cost = sweep.run(part[k], minCost, tried);
            if (cost >= minCost) continue;
            minCost = cost;
            best.swap(tried);
        }
        if (minCost == Tuning::hopeless) return std::nullopt;
        order.insert(order.end(), best.begin(), best.end());
    }
    return order;
}

} // namespace

std::optional<std::vector<Step>> eliminationOrder(const SearchState& state, const Control& control) {
    const Ties ties(state);
    IdVector<VariableId, bool> placed(state.problem().domains.size(), false);
    std::vector<Step> steps;
    const auto place = [&](VariableId variable) {
        if (!placed[variable]) steps.push_back({variable, {}, {}});
        placed[variable] = true;
    };
    const auto order = crossingOrder(ties, control);
    if (!order) return std::nullopt;
    for (const CrossingId crossing : *order) {
        const std::vector<ItemId>& items = ties.itemsOf[crossing];
        for (const ItemId item : items)
            if (const auto [variable, chain] = ties.meaning(item); variable.valid()) place(variable);
        for (const ItemId item : items)
            if (const auto [variable, chain] = ties.meaning(item); chain.valid())
                steps.push_back({{}, chain, crossing});
    }
    for (const VariableId variable : state.problem().variables())
        if (state.isFree(variable)) place(variable);
    return steps;
}

} // namespace qm
