#include "enumerate/diagram/elimination_order.h"

#include "base/infinity.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

/// Grows an order of crossings from a starting point, and sums up the estimated states. Time is linear in
/// what it reaches, up to a logarithm.
class Sweep {
public:
    explicit Sweep(const Ties& ties)
        : ties_(ties), taken_(ties.crossingsOf.size(), 0), changes_(ties.itemsOf.size()),
          seen_(ties.itemsOf.size(), Seen::no) {}

    /// \return the estimate, or infinity once it reaches `limit`
    double run(CrossingId start, double limit, std::vector<CrossingId>& order) {
        forget();
        order.clear();
        see(start);
        int open = 0;
        double cost = 0;
        while (!border_.empty()) {
            const auto [change, crossing] = *border_.begin();
            border_.erase(border_.begin());
            open += change;
            take(crossing);
            order.push_back(crossing);
            cost += std::pow(Tuning::growth, open);
            if (cost >= limit) return infinity;
        }
        return cost;
    }

private:
    enum class Seen : char { no, border, done };

    void forget() {
        for (const CrossingId crossing : reached_) {
            seen_[crossing] = Seen::no;
            for (const ItemId item : ties_.itemsOf[crossing])
                taken_[item] = 0;
        }
        reached_.clear();
        border_.clear();
    }

    void see(CrossingId crossing) {
        seen_[crossing] = Seen::border;
        reached_.push_back(crossing);
        changes_[crossing] = static_cast<int>(std::ranges::count_if(
            ties_.itemsOf[crossing], [&](ItemId item) { return ties_.crossingsOf[item].size() > 1; }));
        border_.emplace(changes_[crossing], crossing);
    }

    /// The first crossing of an item opens it, and the last one closes it: both change what the others would
    /// do.
    void take(CrossingId crossing) {
        seen_[crossing] = Seen::done;
        for (const ItemId item : ties_.itemsOf[crossing]) {
            const std::vector<CrossingId>& all = ties_.crossingsOf[item];
            ++taken_[item];
            const int less = (taken_[item] == 1 ? 1 : 0) + (taken_[item] + 1 == all.size() ? 1 : 0);
            if (less == 0) continue;
            for (const CrossingId other : all)
                if (seen_[other] != Seen::done) reduceChange(other, less);
        }
    }

    void reduceChange(CrossingId crossing, int less) {
        if (seen_[crossing] == Seen::no) see(crossing);
        border_.erase({changes_[crossing], crossing});
        changes_[crossing] -= less;
        border_.emplace(changes_[crossing], crossing);
    }

    const Ties& ties_;
    IdVector<ItemId, std::size_t> taken_; ///< of every item, its crossings that are in the order already
    IdVector<CrossingId, int> changes_;   ///< of the number of open items, if a seen crossing came next
    IdVector<CrossingId, Seen> seen_;
    std::vector<CrossingId> reached_; ///< that have been seen
    std::set<std::pair<int, CrossingId>> border_;
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
