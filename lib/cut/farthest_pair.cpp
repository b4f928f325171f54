#include "cut/farthest_pair.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace qm {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();
constexpr std::size_t exactSweeps = 24;
/// With at most this many candidates a bound is kept for every pair; with more, one for every candidate.
constexpr std::size_t pairLimit = 2048;

class Search {
public:
    Search(const std::vector<VertexId>& vertices, SurfaceDistances& distances)
        : vertices_(vertices), distances_(distances), upper_(vertices.size(), unbounded),
          open_(vertices.size()) {
        std::iota(open_.begin(), open_.end(), std::size_t{0});
    }

    FarthestPair run() {
        for (std::size_t next = 0; next < vertices_.size(); next = promising()) {
            const std::vector<double> distances = sweep(next);
            update(next, distances);
            dropHopeless(next);
            if (!paired_ && open_.size() <= pairLimit) beginPairs();
        }
        const auto known = swept_.find(best_.second);
        best_.fromSecond = known != swept_.end() ? std::move(known->second) : sweep(best_.second);
        if (best_.first > best_.second) {
            std::swap(best_.first, best_.second);
            std::swap(best_.fromFirst, best_.fromSecond);
        }
        return std::move(best_);
    }

private:
    std::vector<double> sweep(std::size_t from) { return distances_.between(vertices_[from], vertices_); }

    void update(std::size_t from, const std::vector<double>& distances) {
        ++sweeps_;
        std::size_t farthest = from == 0 ? 1 : 0;
        for (std::size_t k = 0; k < distances.size(); ++k)
            if (distances[k] > distances[farthest]) farthest = k;
        if (distances[farthest] > longest_) {
            longest_ = distances[farthest];
            best_.first = from;
            best_.second = farthest;
            best_.fromFirst = distances;
        }
        for (const std::size_t k : open_)
            upper_[k] = std::min(upper_[k], static_cast<float>(distances[farthest] + distances[k]));
        if (sweeps_ <= exactSweeps) swept_[from] = distances;
        if (paired_) boundPairs(distances);
    }

    /// A pair must be farther apart than this to be worth looking for.
    [[nodiscard]] float threshold() const {
        const double slack = sweeps_ <= exactSweeps ? 0 : 0.01 * static_cast<double>(sweeps_ - exactSweeps);
        return static_cast<float>(longest_ * (1 + slack));
    }

    /// Drops the vertex just swept, whose farthest partner is known now, and those that are too near to all
    /// others.
    void dropHopeless(std::size_t swept) {
        const float enough = threshold();
        const auto hopeless = [&](std::size_t k) { return k == swept || upper_[k] <= enough; };
        std::erase_if(open_, hopeless);
    }

    void beginPairs() {
        paired_ = true;
        row_.assign(vertices_.size(), 0);
        rows_ = open_.size();
        for (std::size_t r = 0; r < rows_; ++r)
            row_[open_[r]] = r;
        pairs_.assign(rows_ * rows_, unbounded);
        for (const auto& [from, distances] : swept_)
            boundPairs(distances);
    }

    void boundPairs(const std::vector<double>& distances) {
        for (const std::size_t i : open_)
            for (const std::size_t j : open_) {
                float& bound = pairs_[row_[i] * rows_ + row_[j]];
                bound = std::min(bound, static_cast<float>(distances[i] + distances[j]));
            }
    }

    /// The open vertex with the largest number of partners that may be farther away than the farthest pair so
    /// far; in the first sweeps, the one with the largest bound. The number of vertices if there is none.
    [[nodiscard]] std::size_t promising() const {
        const float enough = threshold();
        std::size_t best = vertices_.size();
        float bestValue = 0;
        for (const std::size_t i : open_) {
            float partners = 0;
            if (paired_)
                for (const std::size_t j : open_)
                    if (i != j && pairs_[row_[i] * rows_ + row_[j]] > enough) ++partners;
            const float value = paired_ && partners == 0 ? 0 : !paired_ || sweeps_ < 3 ? upper_[i] : partners;
            if (value <= bestValue) continue;
            bestValue = value;
            best = i;
        }
        return best;
    }

    const std::vector<VertexId>& vertices_;
    SurfaceDistances& distances_;
    std::vector<float> upper_;      ///< bound on the distance to the farthest partner
    std::vector<std::size_t> open_; ///< those that may be one of the farthest pair and were not swept
    std::map<std::size_t, std::vector<double>> swept_; ///< the first sweeps, by where they began
    bool paired_ = false;
    std::vector<std::size_t> row_; ///< of an open vertex, in the bounds for pairs
    std::size_t rows_ = 0;
    std::vector<float> pairs_;
    FarthestPair best_;
    double longest_ = -1;
    std::size_t sweeps_ = 0;
};

} // namespace

FarthestPair farthestPair(const std::vector<VertexId>& vertices, SurfaceDistances& distances) {
    return Search(vertices, distances).run();
}

} // namespace qm
