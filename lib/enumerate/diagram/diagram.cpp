#include "enumerate/diagram/diagram.h"

#include "enumerate/diagram/border.h"

#include <algorithm>

namespace qm {
namespace {

constexpr std::size_t maxSteps = 20000; ///< bounds the depth of the recursion

/// The nodes before one step, found by the description of their state: an open hash table.
class KnownNodes {
public:
    /// The node of a description; may be `none`, if the description is known to lead to no graph.
    /// \return null if the description is new
    const Diagram::NodeId* find(const std::uint64_t* key, std::size_t words) {
        if (slots_.empty()) return nullptr;
        const std::size_t entry = slots_[slotOf(key, words)];
        return entry == 0 ? nullptr : &nodes_[entry - 1];
    }

    void insert(const std::uint64_t* key, std::size_t words, Diagram::NodeId node) {
        if (2 * (nodes_.size() + 1) > slots_.size()) grow(words);
        slots_[slotOf(key, words)] = static_cast<std::uint32_t>(nodes_.size() + 1);
        keys_.insert(keys_.end(), key, key + words);
        nodes_.push_back(node);
    }

private:
    [[nodiscard]] std::size_t slotOf(const std::uint64_t* key, std::size_t words) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15;
        for (std::size_t k = 0; k < words; ++k) {
            hash = (hash ^ key[k]) * 0xff51afd7ed558ccd;
            hash ^= hash >> 32;
        }
        std::size_t slot = hash & (slots_.size() - 1);
        while (slots_[slot] != 0 && !std::equal(key, key + words, keys_.data() + (slots_[slot] - 1) * words))
            slot = (slot + 1) & (slots_.size() - 1);
        return slot;
    }

    void grow(std::size_t words) {
        slots_.assign(std::max<std::size_t>(8, 2 * slots_.size()), 0);
        for (std::size_t k = 0; k < nodes_.size(); ++k)
            slots_[slotOf(keys_.data() + k * words, words)] = static_cast<std::uint32_t>(k + 1);
    }

    std::vector<std::uint32_t> slots_; ///< number of the entry plus 1; 0 for an empty slot
    std::vector<std::uint64_t> keys_;
    std::vector<Diagram::NodeId> nodes_;
};

class Builder {
public:
    Builder(const Problem& problem, std::size_t maxNodes, const Control& control)
        : problem_(problem), state_(problem), maxNodes_(maxNodes), control_(control) {}

    std::optional<Diagram> run() {
        diagram_.nodes.resize(2);
        if (!state_.consistent()) return std::move(diagram_);
        diagram_.fixed = state_.assignment();
        diagram_.fixedCost = qm::costOf(problem_, diagram_.fixed);
        if (state_.freeVariables() > maxSteps) return std::nullopt; // every one takes a step
        auto steps = eliminationOrder(state_, control_);
        if (!steps || steps->size() > maxSteps) return std::nullopt;
        steps_ = std::move(*steps);
        border_.emplace(state_, steps_);
        known_.resize(steps_.size());
        stepOf_.assign(problem_.domains.size(), -1);
        for (std::size_t k = 0; k < steps_.size(); ++k)
            if (steps_[k].variable.valid()) stepOf_[steps_[k].variable] = static_cast<int>(k);
        diagram_.root = build(0);
        if (stopped_) return std::nullopt;
        return std::move(diagram_);
    }

private:
    /// The node for everything that the state leaves undecided from this step on.
    Diagram::NodeId build(std::size_t step) {
        if (step == steps_.size()) return Diagram::end;
        const Step& decision = steps_[step];
        if (decision.chain.valid() && !needsCover(decision)) return build(step + 1);
        const std::size_t words = border_->words(step);
        std::vector<std::uint64_t> key(words);
        border_->describe(state_, step, key.data());
        if (const Diagram::NodeId* node = known_[step].find(key.data(), words)) return *node;
        const Diagram::Node node{decision.variable, follow(step, true), follow(step, false),
                                 decision.variable.valid() ? costOf(decision.variable, step) : 0};
        if (stopped_) return Diagram::none;
        const Diagram::NodeId id = add(node);
        known_[step].insert(key.data(), words, id);
        stopped_ = ++described_ > maxNodes_ || (described_ % 4096 == 0 && control_.stopRequested());
        return id;
    }

    [[nodiscard]] bool needsCover(const Step& decision) const {
        return state_.coverOfChain(decision.chain) == Cover::open &&
               state_.cracks().isCrossed(decision.crossing);
    }

    /// The cost of setting a variable to in, with the corners that it makes with arcs of earlier steps.
    [[nodiscard]] double costOf(VariableId variable, std::size_t step) const {
        double cost = problem_.costs[variable];
        const auto decidedIn = [&](VariableId arc) {
            return state_.value(arc) == ArcState::in && stepOf_[arc] < static_cast<int>(step);
        };
        for (const CrossingId id : state_.crossingsOf(variable)) {
            const Crossing& crossing = problem_.crossings[id];
            if (crossing.cornerCost == 0) continue;
            for (const std::size_t k : {0U, 1U}) {
                const CrossingSide& own = crossing.sides[k];
                const CrossingSide& other = crossing.sides[1 - k];
                const int arcs = (own.before == variable ? 1 : 0) + (own.after == variable ? 1 : 0);
                const int others = (decidedIn(other.before) ? 1 : 0) + (decidedIn(other.after) ? 1 : 0);
                cost += crossing.cornerCost * cornersAt(arcs, others);
            }
        }
        return cost;
    }

    Diagram::NodeId follow(std::size_t step, bool in) {
        const Step& decision = steps_[step];
        const SearchState::Mark mark = state_.mark();
        const bool possible = decision.chain.valid() ? state_.decideCover(decision.chain, in)
                                                     : state_.assign(decision.variable, arcState(in));
        const Diagram::NodeId node = possible && !stopped_ ? build(step + 1) : Diagram::none;
        state_.undo(mark);
        return node;
    }

    Diagram::NodeId add(const Diagram::Node& node) {
        if (node.in == Diagram::none && node.out == Diagram::none) return Diagram::none;
        if (!node.variable.valid() && node.in == Diagram::none) return node.out;
        if (!node.variable.valid() && node.out == Diagram::none) return node.in;
        diagram_.nodes.push_back(node);
        return static_cast<Diagram::NodeId>(diagram_.nodes.size() - 1);
    }

    const Problem& problem_;
    SearchState state_;
    std::size_t maxNodes_;
    const Control& control_;
    std::vector<Step> steps_;
    IdVector<VariableId, int> stepOf_; ///< that decides a variable; -1 if it is the same in all graphs
    std::optional<DiagramBorder> border_;
    std::vector<KnownNodes> known_; ///< for every step, the nodes before it
    Diagram diagram_;
    std::size_t described_ = 0;
    bool stopped_ = false;
};

} // namespace

std::optional<Diagram> buildDiagram(const Problem& problem, std::size_t maxNodes, const Control& control) {
    return Builder(problem, maxNodes, control).run();
}

} // namespace qm
