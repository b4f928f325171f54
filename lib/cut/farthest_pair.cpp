#include "cut/farthest_pair.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace qm {
namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();
/// Up to this many sweeps the result is exact, which usually suffices. Each further sweep allows an error of
/// another one per cent, so that few follow.
constexpr std::size_t exactSweeps = 24;
constexpr double slackPerSweep = 0.01;
/// Up to this many candidates, a bound is kept for every pair; with more, one for every candidate.
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

    /// The distance that a pair must exceed to be worth looking for.
    [[nodiscard]] float threshold() const {
        const double slack =
            sweeps_ <= exactSweeps ? 0 : slackPerSweep * static_cast<double>(sweeps_ - exactSweeps);
        return static_cast<float>(longest_ * (1 + slack));
    }

    /// Drops the vertex just swept, whose farthest partner is known now, and all vertices that are too near
    /// to all others.
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
        for (std::size_t k = 0; k < open_.size(); ++k) { // each pair once
            const std::size_t i = open_[k];
            float* bounds = &pairs_[row_[i] * rows_];
            for (std::size_t l = 0; l < k; ++l) {
                float& bound = bounds[row_[open_[l]]];
                bound = std::min(bound, static_cast<float>(distances[i] + distances[open_[l]]));
            }
        }
    }

    /// The open vertex with the most partners that may be farther away than the farthest pair known; in the
    /// first sweeps, the one with the largest bound; the number of vertices if there is none. Vertices
    /// without such partners are dropped, because they can neither get new ones nor be a partner.
    [[nodiscard]] std::size_t promising() {
        std::size_t best = vertices_.size(), kept = 0;
        float bestValue = 0;
        const std::vector<std::size_t> partners = countPartners();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const std::size_t i = open_[k];
            if (paired_ && partners[k] == 0) continue;
            open_[kept++] = i;
            const float value = !paired_ || sweeps_ < 3 ? upper_[i] : static_cast<float>(partners[k]);
            if (value <= bestValue) continue;
            bestValue = value;
            best = i;
        }
        open_.resize(kept);
        return best;
    }

    /// For every open vertex, the number of its partners that may be far enough away.
    [[nodiscard]] std::vector<std::size_t> countPartners() const {
        std::vector<std::size_t> partners(open_.size(), 0);
        if (!paired_) return partners;
        const float enough = threshold();
        for (std::size_t k = 0; k < open_.size(); ++k) {
            const float* bounds = &pairs_[row_[open_[k]] * rows_];
            for (std::size_t l = 0; l < k; ++l) {
                const bool maybe = bounds[row_[open_[l]]] > enough;
                partners[k] += maybe ? 1 : 0;
                partners[l] += maybe ? 1 : 0;
            }
        }
        return partners;
    }

    const std::vector<VertexId>& vertices_;
    SurfaceDistances& distances_;
    std::vector<float> upper_;      ///< upper bound of the distance to the farthest partner
    std::vector<std::size_t> open_; ///< vertices not yet swept that may belong to the farthest pair
    std::map<std::size_t, std::vector<double>> swept_; ///< distances of the first sweeps, by starting vertex
    bool paired_ = false;
    std::vector<std::size_t> row_; ///< row of an open vertex in the bounds for pairs
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
