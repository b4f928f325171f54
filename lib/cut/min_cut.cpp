#include "cut/min_cut.h"

#include "base/at.h"

// GCC 12 reports an empty boost::optional inside the graph's edge iterators as uninitialised.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <cstddef>
#include <numeric>

namespace qm {
namespace {

struct Neighbour {
    int node;
    double capacity;
};

/// Fixes the labels that are certain. Open nodes have label -1, and take over the pull of fixed neighbours.
class Fixing {
public:
    explicit Fixing(const CutProblem& problem)
        : costs_(problem.costs), labels_(problem.costs.size(), -1), slack_(problem.costs.size(), 0),
          firstNeighbour_(problem.costs.size() + 1, 0), neighbours_(2 * problem.edges.size()) {
        for (const auto& [a, b, capacity] : problem.edges) {
            ++firstNeighbour_[at(a) + 1];
            ++firstNeighbour_[at(b) + 1];
        }
        std::partial_sum(firstNeighbour_.begin(), firstNeighbour_.end(), firstNeighbour_.begin());
        std::vector<std::size_t> next(firstNeighbour_.begin(), firstNeighbour_.end() - 1);
        for (const auto& [a, b, capacity] : problem.edges) {
            neighbours_[next[at(a)]++] = {b, capacity};
            neighbours_[next[at(b)]++] = {a, capacity};
            slack_[at(a)] += capacity;
            slack_[at(b)] += capacity;
        }
    }

    void run() {
        for (int node = 0; node < static_cast<int>(labels_.size()); ++node)
            tryFix(node);
        while (!pending_.empty()) {
            const int node = pending_.back();
            pending_.pop_back();
            for (std::size_t k = firstNeighbour_[at(node)]; k < firstNeighbour_[at(node) + 1]; ++k) {
                const Neighbour& neighbour = neighbours_[k];
                if (labels_[at(neighbour.node)] >= 0) continue;
                costs_[at(neighbour.node)][at(1 - labels_[at(node)])] += neighbour.capacity;
                slack_[at(neighbour.node)] -= neighbour.capacity;
                tryFix(neighbour.node);
            }
        }
    }

    [[nodiscard]] const std::vector<std::array<double, 2>>& costs() const { return costs_; }
    std::vector<int>& labels() { return labels_; }

private:
    void tryFix(int node) {
        if (labels_[at(node)] >= 0) return;
        const double preference = costs_[at(node)][1] - costs_[at(node)][0];
        if (preference > slack_[at(node)])
            labels_[at(node)] = 0;
        else if (-preference > slack_[at(node)])
            labels_[at(node)] = 1;
        else
            return;
        pending_.push_back(node);
    }

    std::vector<std::array<double, 2>> costs_;
    std::vector<int> labels_;
    std::vector<double> slack_;               ///< capacity to open neighbours
    std::vector<std::size_t> firstNeighbour_; ///< of every node, in neighbours_; and the end
    std::vector<Neighbour> neighbours_;
    std::vector<int> pending_;
};

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Graph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_color_t, boost::default_color_type,
                    boost::property<boost::vertex_distance_t, long,
                                    boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>,
    boost::property<boost::edge_capacity_t, double,
                    boost::property<boost::edge_residual_capacity_t, double,
                                    boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

void connect(Graph& graph, std::size_t a, std::size_t b, double forward, double backward) {
    const auto there = boost::add_edge(a, b, graph).first, back = boost::add_edge(b, a, graph).first;
    boost::put(boost::edge_capacity, graph, there, forward);
    boost::put(boost::edge_capacity, graph, back, backward);
    boost::put(boost::edge_reverse, graph, there, back);
    boost::put(boost::edge_reverse, graph, back, there);
}

} // namespace

std::vector<int> minimumCut(const CutProblem& problem) {
    Fixing fixing(problem);
    fixing.run();
    std::vector<int>& labels = fixing.labels();
    std::vector<std::size_t> nodeOf(labels.size());
    std::size_t open = 0;
    for (std::size_t k = 0; k < labels.size(); ++k)
        if (labels[k] < 0) nodeOf[k] = open++;
    Graph graph(open + 2);
    const std::size_t source = open, sink = open + 1;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (labels[k] >= 0) continue;
        connect(graph, source, nodeOf[k], fixing.costs()[k][1], 0);
        connect(graph, nodeOf[k], sink, fixing.costs()[k][0], 0);
    }
    for (const auto& [a, b, capacity] : problem.edges)
        if (labels[at(a)] < 0 && labels[at(b)] < 0)
            connect(graph, nodeOf[at(a)], nodeOf[at(b)], capacity, capacity);
    boost::boykov_kolmogorov_max_flow(graph, source, sink);
    const auto colours = boost::get(boost::vertex_color, graph);
    const auto sourceColour = boost::get(colours, source);
    for (std::size_t k = 0; k < labels.size(); ++k)
        if (labels[k] < 0) labels[k] = boost::get(colours, nodeOf[k]) == sourceColour ? 0 : 1;
    return labels;
}

} // namespace qm
