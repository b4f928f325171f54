#include "base/infinity.h"
#include "enumerate/relaxation/acyclic_graph.h"
#include "enumerate/relaxation/cuts.h"
#include "enumerate/relaxation/smallest_cut.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace qm {
namespace {

using Tuning = CutTuning;
using SideId = PassGraph::SideId;

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

class TrailSearch {
public:
    TrailSearch(const PassGraph& graph, const ColumnValues& values, double price)
        : sides_(graph.sides()), values_(values), price_(price), placeOf_(sides_.size() / 2, nowhere),
          isCut_(sides_.size() / 2, false) {}

    std::vector<Formulation::Row> run() {
        std::vector<Formulation::Row> rows;
        for (const Arrival& arrival : arrivals()) {
            if (isCut_[arrival.crossing]) continue; // would most likely yield the same row again
            collect(arrival.crossing);
            chooseInner();
            if (auto row = cutFrom(arrival.column); !row.columns.empty()) rows.push_back(std::move(row));
            for (const std::size_t crossing : region_)
                placeOf_[crossing] = nowhere;
        }
        return rows;
    }

private:
    struct Arrival {
        ColumnId column;
        std::size_t crossing;
    };
    /// A possible pass of a crossing of the region: one particle on one line.
    struct Pass {
        std::size_t place;
        ColumnId column;
        std::size_t next; ///< the place of the next crossing; `nowhere` if that is not in the region
        bool inner = false;
    };

    [[nodiscard]] double value(ColumnId column) const { return column.valid() ? values_[column] : 0; }

    /// The arrivals that are worth a search, those of highest value first. An arrival that passes in full is
    /// left out, because the next crossing serves as well.
    [[nodiscard]] std::vector<Arrival> arrivals() const {
        std::vector<Arrival> found;
        for (const SideId side : sides_.ids())
            for (std::size_t k = 0; k < PassGraph::directions; ++k) {
                const ColumnId column = sides_[side].arrives[k];
                if (value(column) >= Tuning::minArrival &&
                    value(column) - value(sides_[side].passes[k]) >= Tuning::minLoss)
                    found.push_back({column, side.idx() / 2});
            }
        std::ranges::stable_sort(found, std::greater{},
                                 [this](const Arrival& arrival) { return values_[arrival.column]; });
        return found;
    }

    template <class Visit> void forEachPass(std::size_t crossing, const Visit& visit) const {
        for (const std::size_t side : {2 * crossing, 2 * crossing + 1})
            for (std::size_t k = 0; k < PassGraph::directions; ++k) {
                const PassGraph::Side& line = sides_[SideId(side)];
                if (line.passes[k].valid())
                    visit(line.passes[k], line.next[k].valid() ? line.next[k].idx() / 2 : nowhere);
            }
    }

    /// Collects the nearest crossings that a trail may reach, and all their passes.
    void collect(std::size_t start) {
        region_.assign(1, start);
        placeOf_[start] = 0;
        passes_.clear();
        for (std::size_t k = 0; k < region_.size(); ++k)
            forEachPass(region_[k], [&](ColumnId column, std::size_t next) {
                passes_.push_back({k, column, next});
                if (next == nowhere || placeOf_[next] != nowhere || value(column) <= Tuning::slight ||
                    region_.size() == Tuning::maxCrossings)
                    return;
                placeOf_[next] = region_.size();
                region_.push_back(next);
            });
        for (Pass& pass : passes_)
            if (pass.next != nowhere) pass.next = placeOf_[pass.next];
        std::ranges::stable_sort(passes_, std::greater{},
                                 [this](const Pass& pass) { return values_[pass.column]; });
    }

    /// Chooses passes inside the region that form no cycle, those of highest value first.
    void chooseInner() {
        AcyclicGraph loopless(region_.size());
        for (Pass& pass : passes_)
            pass.inner = pass.next != nowhere && value(pass.column) > Tuning::slight &&
                         loopless.add(pass.place, pass.next);
    }

    /// \return a row without columns if the arrival yields no violated row
    [[nodiscard]] Formulation::Row cutFrom(ColumnId arrival) {
        const std::size_t sink = region_.size();
        SmallestCut cut(region_.size() + 1);
        for (const Pass& pass : passes_)
            cut.addEdge(pass.place, pass.inner ? pass.next : sink, values_[pass.column] + price_);
        cut.find(0, sink);
        Formulation::Row row{{arrival}, {-1}, 0, infinity};
        double sum = -values_[arrival];
        AcyclicGraph loopless(region_.size()); // inside the cut's set, more passes may fit without a cycle
        for (const Pass& pass : passes_)
            if (pass.inner && cut.isBefore(pass.place) && cut.isBefore(pass.next))
                loopless.add(pass.place, pass.next);
        for (const Pass& pass : passes_) {
            if (!cut.isBefore(pass.place)) continue;
            const bool stays = pass.next != nowhere && cut.isBefore(pass.next);
            if (stays && (pass.inner || loopless.add(pass.place, pass.next))) continue;
            row.add(pass.column, 1);
            sum += values_[pass.column];
        }
        if (sum > -Tuning::minViolation) return {};
        for (std::size_t k = 0; k < region_.size(); ++k)
            if (cut.isBefore(k)) isCut_[region_[k]] = true;
        return row;
    }

    const IdVector<SideId, PassGraph::Side>& sides_;
    const ColumnValues& values_;
    const double price_;
    std::vector<std::size_t> region_;  ///< the crossings of the region, by place
    std::vector<std::size_t> placeOf_; ///< the place of every crossing; `nowhere` outside the region
    std::vector<Pass> passes_;         ///< all passes of the region
    std::vector<bool> isCut_;          ///< crossings that are in the set of a row already
};

} // namespace

std::vector<Formulation::Row> brokenTrails(const PassGraph& graph, const ColumnValues& values, double price) {
    return TrailSearch(graph, values, price).run();
}

} // namespace qm
