#include "support/brute_force.h"

#include "base/at.h"

#include <algorithm>

namespace qm::test {

namespace {

using check::Arrival;
using check::Way;

/// What is known about a condition while some coordinates are not chosen yet.
enum class Answer { no, maybe, yes };

Answer either(Answer a, Answer b) {
    return std::max(a, b);
}
Answer both(Answer a, Answer b) {
    return std::min(a, b);
}
Answer answer(bool yes) {
    return yes ? Answer::yes : Answer::no;
}

constexpr int notChosen = -1;

class Search {
public:
    Search(const check::Neighbourhoods& around, const check::LineNetwork& network,
           const check::EdgeCosts& costs, std::uint64_t maxSteps)
        : around_(around), network_(network), costs_(costs), stepsLeft_(maxSteps),
          x_(network.ways.size(), notChosen) {
        orderWays();
    }

    BruteForce run() {
        choose(0);
        return std::move(result_);
    }

private:
    [[nodiscard]] const Way& way(int w) const { return network_.ways[at(w)]; }
    [[nodiscard]] int x(int w) const { return x_[at(w)]; }

    /// Orders the ways such that ways that meet are close together, and contradictions show early. Lines
    /// without junctions are walked by the first of their two particles.
    void orderWays() {
        std::vector<char> seen(network_.ways.size(), 0);
        for (int start = 0; start < static_cast<int>(network_.ways.size()); ++start) {
            if (way(start).length() == 1) {
                const bool second = way(start).opposite >= 0 && way(start).opposite < start;
                x_[at(start)] = second ? 0 : 1;
                result_.uncrossedLines += second;
                continue;
            }
            if (seen[at(start)]) continue;
            seen[at(start)] = 1;
            std::size_t next = order_.size();
            order_.push_back(start);
            for (; next < order_.size(); ++next)
                for (const int other : neighbours(order_[next])) {
                    if (seen[at(other)]) continue;
                    seen[at(other)] = 1;
                    order_.push_back(other);
                }
        }
    }

    /// The opposite of a way, and all ways that cross it.
    [[nodiscard]] std::vector<int> neighbours(int w) const {
        std::vector<int> found;
        if (way(w).opposite >= 0) found.push_back(way(w).opposite);
        for (const int crossing : way(w).stops)
            for (const Arrival& arrival : network_.crossings[at(crossing)].from)
                if (arrival.way >= 0) found.push_back(arrival.way);
        return found;
    }

    void choose(std::size_t depth) {
        result_.complete = result_.complete && stepsLeft_-- > 0;
        if (!result_.complete) return;
        if (depth == order_.size()) {
            record();
            return;
        }
        const int w = order_[depth];
        const std::vector<int> affected = neighbours(w);
        for (x_[at(w)] = 0; x(w) <= way(w).length(); ++x_[at(w)])
            if (possible(w) &&
                std::all_of(affected.begin(), affected.end(), [&](int o) { return possible(o); }))
                choose(depth + 1);
        x_[at(w)] = notChosen;
    }

    /// False if the coordinates chosen so far break a rule for this way, whatever the others will be.
    [[nodiscard]] bool possible(int w) const {
        return x(w) == notChosen || (overlapFree(w) && crossingFree(w) && busy(w) && stopped(w));
    }

    [[nodiscard]] bool overlapFree(int w) const { // A1
        const int opposite = way(w).opposite;
        return opposite < 0 || x(opposite) == notChosen || x(w) + x(opposite) <= way(w).length();
    }

    [[nodiscard]] bool crossingFree(int w) const { // A2
        for (int k = 1; k < way(w).length() && k < x(w); ++k) {
            const check::Meeting here = check::meetingAt(network_, w, k);
            if (here.crossing->seeded) return false;
            if (passes(here.left()) == Answer::yes || passes(here.right()) == Answer::yes) return false;
        }
        return true;
    }

    [[nodiscard]] bool busy(int w) const { // A3
        if (x(w) > 0) return true;
        const int opposite = way(w).opposite;
        return opposite >= 0 && (x(opposite) == notChosen || x(opposite) == way(w).length());
    }

    [[nodiscard]] bool stopped(int w) const { // A4
        if (x(w) == 0 || x(w) == way(w).length()) return true;
        const check::Meeting here = check::meetingAt(network_, w, x(w));
        const int opposite = way(w).opposite;
        Answer stop = answer(here.crossing->seeded);
        if (opposite >= 0)
            stop = either(stop, x(opposite) == notChosen ? Answer::maybe
                                                         : answer(x(w) + x(opposite) == way(w).length()));
        stop = either(stop, either(passes(here.left()), passes(here.right())));
        stop = either(stop, both(endsAt(here.left()), endsAt(here.right())));
        return stop != Answer::no;
    }

    [[nodiscard]] Answer passes(const Arrival& other) const {
        if (other.way < 0) return Answer::no;
        return x(other.way) == notChosen ? Answer::maybe : answer(x(other.way) > other.coordinate);
    }
    [[nodiscard]] Answer endsAt(const Arrival& other) const {
        if (other.way < 0) return Answer::no;
        return x(other.way) == notChosen ? Answer::maybe : answer(x(other.way) == other.coordinate);
    }

    void record() {
        ++result_.vectors;
        std::vector<int> edges;
        double cost = 0;
        for (int w = 0; w < static_cast<int>(x_.size()); ++w)
            for (int step = 0; step < way(w).stepsTo(x(w)); ++step)
                edges.push_back(around_.edge(way(w).steps[at(step)]));
        for (const int edge : edges)
            cost += costs_.cost[at(edge)];
        std::sort(edges.begin(), edges.end());
        result_.graphs.try_emplace(std::move(edges), BruteForce::Graph{cost, x_});
    }

    const check::Neighbourhoods& around_;
    const check::LineNetwork& network_;
    const check::EdgeCosts& costs_;
    std::uint64_t stepsLeft_;
    std::vector<int> x_;
    std::vector<int> order_;
    BruteForce result_;
};

} // namespace

BruteForce bruteForce(const check::Neighbourhoods& around, const check::LineNetwork& network,
                      const check::EdgeCosts& costs, std::uint64_t maxSteps) {
    return Search(around, network, costs, maxSteps).run();
}

} // namespace qm::test
