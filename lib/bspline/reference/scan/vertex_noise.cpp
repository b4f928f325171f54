#include "bspline/reference/scan/vertex_noise.h"

#include "base/at.h"
#include "base/order_statistics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>

namespace qm {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::array<int, 3>>;

/// The neighbours of every vertex, one vertex after the other.
class Neighbours {
public:
    Neighbours(std::size_t vertices, const Faces& faces) : begins_(vertices + 1) {
        for (const auto& face : faces)
            for (const int corner : face)
                begins_[at(corner) + 1] += 2;
        for (std::size_t k = 0; k < vertices; ++k)
            begins_[k + 1] += begins_[k];
        all_.resize(begins_.back());
        std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
        for (const auto& face : faces)
            for (std::size_t k = 0; k < 3; ++k)
                for (const std::size_t step : {1U, 2U})
                    all_[next[at(face[k])]++] = face[(k + step) % 3];
        ends_.reserve(vertices);
        for (std::size_t k = 0; k < vertices; ++k) { // every edge has come once for each of its triangles
            const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(begins_[k]);
            const auto end = all_.begin() + static_cast<std::ptrdiff_t>(begins_[k + 1]);
            std::sort(begin, end);
            ends_.push_back(begins_[k] + static_cast<std::size_t>(std::unique(begin, end) - begin));
        }
    }

    [[nodiscard]] std::span<const int> of(std::size_t vertex) const {
        return std::span(all_).subspan(begins_[vertex], ends_[vertex] - begins_[vertex]);
    }

private:
    std::vector<std::size_t> begins_;
    std::vector<std::size_t> ends_;
    std::vector<int> all_;
};

/// By vertex: whether all triangles around it are within 37 degrees of its normal.
std::vector<bool> smoothVertices(const Points& points, const Faces& faces, const Points& normals) {
    constexpr double minCosine = 0.8;
    std::vector<bool> result(points.size(), true);
    for (const auto& [a, b, c] : faces) {
        const Eigen::Vector3d normal = (points[at(b)] - points[at(a)]).cross(points[at(c)] - points[at(a)]);
        for (const int corner : {a, b, c})
            if (!(normal.dot(normals[at(corner)]) > minCosine * normal.norm())) result[at(corner)] = false;
    }
    return result;
}

/// Twice the difference from the mean of the neighbours: of the points, and of these differences.
class Bilaplacian {
public:
    Bilaplacian(const Points& points, const Neighbours& neighbours)
        : points_(points), neighbours_(neighbours) {}

    [[nodiscard]] bool exists(std::size_t vertex) const {
        return !neighbours_.of(vertex).empty() &&
               std::ranges::none_of(neighbours_.of(vertex),
                                    [&](int beside) { return neighbours_.of(at(beside)).empty(); });
    }

    /// Of a vertex, divided by the root of the sum of all weights' squares: as large as the noise of a
    /// vertex.
    [[nodiscard]] Eigen::Vector3d operator()(std::size_t vertex) {
        weights_.clear();
        addDifference(vertex, 1);
        const auto around = neighbours_.of(vertex);
        for (const int beside : around)
            addDifference(at(beside), -1 / static_cast<double>(around.size()));
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double squares = 0;
        for (const auto& [other, weight] : weights_) {
            sum += weight * points_[other];
            squares += weight * weight;
        }
        return sum / std::sqrt(squares);
    }

private:
    void addDifference(std::size_t vertex, double times) {
        weights_[vertex] += times;
        const auto around = neighbours_.of(vertex);
        for (const int beside : around)
            weights_[at(beside)] -= times / static_cast<double>(around.size());
    }

    const Points& points_;
    const Neighbours& neighbours_;
    std::map<std::size_t, double> weights_; ///< by vertex, of the last call
};

} // namespace

std::optional<double> vertexNoise(const Points& points, const Faces& faces, const Points& normals) {
    constexpr std::size_t many = 20'000; // of them are asked
    constexpr std::size_t few = 100;
    constexpr std::size_t minShare = 4; // one of so many must lie in a smooth place
    const Neighbours neighbours(points.size(), faces);
    const std::vector<bool> isSmooth = smoothVertices(points, faces, normals);
    Bilaplacian bilaplacian(points, neighbours);
    std::vector<double> sizes;
    std::size_t asked = 0;
    for (std::size_t vertex = 0; vertex < points.size(); vertex += 1 + points.size() / many) {
        if (!bilaplacian.exists(vertex)) continue;
        ++asked;
        const auto around = neighbours.of(vertex);
        if (!isSmooth[vertex] || std::ranges::any_of(around, [&](int k) { return !isSmooth[at(k)]; }))
            continue;
        sizes.push_back(std::abs(bilaplacian(vertex).dot(normals[vertex])));
    }
    if (sizes.size() < few || minShare * sizes.size() < asked) return std::nullopt;
    return deviationByMedian * median(sizes);
}

} // namespace qm
