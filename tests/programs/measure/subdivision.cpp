#include "programs/measure/subdivision.h"

#include "check/mesh/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace measure {
namespace {

using qm::check::CheckedMesh;
using qm::check::LayoutPart;
using qm::check::minus;
using qm::check::Neighbourhoods;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

void addTo(Place& sum, double weight, const Place& place) {
    for (std::size_t k = 0; k < 3; ++k)
        sum[k] += weight * place[k];
}

/// The turn, in radians, of a path from a over `at` to b.
double turn(const Place& a, const Place& at, const Place& b) {
    const Place in = minus(at, a);
    const Place out = minus(b, at);
    const double product = in[0] * out[0] + in[1] * out[1] + in[2] * out[2];
    return std::acos(std::clamp(
        product / (std::hypot(in[0], in[1], in[2]) * std::hypot(out[0], out[1], out[2])), -1.0, 1.0));
}

/// The crease through a vertex. A smooth vertex has no neighbours along a crease, a corner has itself twice.
/// A crease may end at a smooth vertex.
struct Rule {
    std::array<int, 2> along{-1, -1};
    int end = -1; ///< the neighbour on a crease that ends at this vertex

    [[nodiscard]] bool isSmooth() const { return along[0] < 0; }
};

struct Mesh {
    std::vector<Place> points;
    std::vector<std::array<int, 4>> quads;
    std::vector<Rule> rules;               ///< by vertex
    std::vector<std::array<int, 2>> edges; ///< the lower vertex first
    std::vector<char> sharp;               ///< by edge
    std::vector<std::array<int, 4>> edgesOfQuad;
};

void findEdges(Mesh& mesh) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> sides;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto a = static_cast<std::uint64_t>(mesh.quads[q][k]);
            const auto b = static_cast<std::uint64_t>(mesh.quads[q][(k + 1) % 4]);
            sides.emplace_back(std::min(a, b) << 32U | std::max(a, b), static_cast<std::uint32_t>(4 * q + k));
        }
    std::sort(sides.begin(), sides.end());
    mesh.edgesOfQuad.resize(mesh.quads.size());
    mesh.edges.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i == 0 || sides[i].first != sides[i - 1].first)
            mesh.edges.push_back(
                {static_cast<int>(sides[i].first >> 32U), static_cast<int>(sides[i].first & 0xffffffffU)});
        mesh.edgesOfQuad[sides[i].second / 4][sides[i].second % 4] = static_cast<int>(mesh.edges.size()) - 1;
    }
}

/// For every vertex, its number of edges, and the sums over its neighbours and over the far corners of its
/// quads.
struct Stars {
    explicit Stars(const Mesh& mesh)
        : valence(mesh.points.size()), near(mesh.points.size()), far(mesh.points.size()) {
        for (const auto& edge : mesh.edges)
            for (std::size_t k = 0; k < 2; ++k) {
                ++valence[index(edge[k])];
                addTo(near[index(edge[k])], 1, mesh.points[index(edge[1 - k])]);
            }
        for (const auto& quad : mesh.quads)
            for (std::size_t k = 0; k < 4; ++k)
                addTo(far[index(quad[k])], 1, mesh.points[index(quad[(k + 2) % 4])]);
    }
    std::vector<int> valence;
    std::vector<Place> near;
    std::vector<Place> far;
};

/// The limit mask of a vertex at which a crease ends: the weights of the vertex, of its neighbours beginning
/// with that on the crease, and of the far corners between them. It is the row to which the powers of the
/// ring's subdivision matrix converge.
std::vector<double> endMask(std::size_t valence) {
    const std::size_t n = valence;
    const double count = static_cast<double>(n);
    std::vector<double> mask(2 * n + 1);
    mask[0] = 1;
    constexpr int powers = 60;
    for (int power = 0; power < powers; ++power) {
        std::vector<double> next(mask.size());
        const auto centreOfQuad = [&](std::size_t k, double weight) {
            for (const std::size_t corner : {std::size_t{0}, 1 + k, 1 + (k + 1) % n, 1 + n + k})
                next[corner] += weight / 4;
        };
        next[0] += mask[0] * (count - 2) / count;
        for (std::size_t k = 0; k < n; ++k) {
            next[1 + k] += mask[0] / (count * count);
            centreOfQuad(k, mask[0] / (count * count) + mask[1 + n + k]);
            const double share = k == 0 ? 0.5 : 0.25;
            next[0] += share * mask[1 + k];
            next[1 + k] += share * mask[1 + k];
            if (k == 0) continue;
            centreOfQuad(k, mask[1 + k] / 4);
            centreOfQuad(k - 1, mask[1 + k] / 4);
        }
        mask = std::move(next);
    }
    return mask;
}

/// The ring of every vertex at which a crease ends, in the order of its mask.
std::vector<std::pair<int, std::vector<int>>> endRings(const Mesh& mesh, const Stars& stars) {
    std::vector<int> place(mesh.points.size(), -1);
    std::vector<std::pair<int, std::vector<std::array<int, 3>>>> fans;
    for (std::size_t v = 0; v < place.size(); ++v)
        if (mesh.rules[v].end >= 0) {
            place[v] = static_cast<int>(fans.size());
            fans.emplace_back(static_cast<int>(v), std::vector<std::array<int, 3>>());
        }
    for (const auto& quad : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k)
            if (place[index(quad[k])] >= 0)
                fans[index(place[index(quad[k])])].second.push_back(
                    {quad[(k + 1) % 4], quad[(k + 2) % 4], quad[(k + 3) % 4]});
    std::vector<std::pair<int, std::vector<int>>> rings;
    for (const auto& [vertex, fan] : fans) {
        const std::size_t n = index(stars.valence[index(vertex)]);
        std::vector<int> ring(2 * n + 1, vertex);
        int near = mesh.rules[index(vertex)].end;
        for (std::size_t k = 0; k < n; ++k) {
            const auto corner =
                std::find_if(fan.begin(), fan.end(), [&](const auto& c) { return c[0] == near; });
            if (corner == fan.end()) break;
            ring[1 + k] = near;
            ring[1 + n + k] = (*corner)[1];
            near = (*corner)[2];
        }
        rings.emplace_back(vertex, std::move(ring));
    }
    return rings;
}

std::vector<Place> limits(const Mesh& mesh) {
    const Stars stars(mesh);
    std::vector<Place> result(mesh.points.size());
    for (std::size_t v = 0; v < result.size(); ++v) {
        const Rule& rule = mesh.rules[v];
        const double n = stars.valence[v];
        if (n == 0) {
            result[v] = mesh.points[v];
        } else if (rule.isSmooth()) {
            addTo(result[v], n / (n + 5), mesh.points[v]);
            addTo(result[v], 4 / (n * (n + 5)), stars.near[v]);
            addTo(result[v], 1 / (n * (n + 5)), stars.far[v]);
        } else {
            addTo(result[v], 4.0 / 6, mesh.points[v]);
            for (const int neighbour : rule.along)
                addTo(result[v], 1.0 / 6, mesh.points[index(neighbour)]);
        }
    }
    std::map<std::size_t, std::vector<double>> masks;
    for (const auto& [vertex, ring] : endRings(mesh, stars)) {
        auto& mask = masks[ring.size()];
        if (mask.empty()) mask = endMask(ring.size() / 2);
        result[index(vertex)] = {};
        for (std::size_t k = 0; k < ring.size(); ++k)
            addTo(result[index(vertex)], mask[k], mesh.points[index(ring[k])]);
    }
    return result;
}

Mesh subdivided(const Mesh& mesh) {
    const int vertices = static_cast<int>(mesh.points.size());
    const int edges = static_cast<int>(mesh.edges.size());
    Mesh result;
    result.points.resize(index(vertices + edges) + mesh.quads.size());
    result.rules.resize(result.points.size());
    Place* edgePoints = &result.points[index(vertices)];
    std::vector<int> facesOfEdge(mesh.edges.size());

    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
        const auto& quad = mesh.quads[q];
        Place& centre = result.points[index(vertices + edges) + q];
        for (const int corner : quad)
            addTo(centre, 0.25, mesh.points[index(corner)]);
        for (const int edge : mesh.edgesOfQuad[q])
            if (!mesh.sharp[index(edge)]) addTo(edgePoints[edge], 0.25, centre);
        const auto& sides = mesh.edgesOfQuad[q];
        const int middle = vertices + edges + static_cast<int>(q);
        const auto side = [&](std::size_t k) { return vertices + sides[k]; };
        result.quads.push_back({quad[0], side(0), middle, side(3)});
        result.quads.push_back({side(0), quad[1], side(1), middle});
        result.quads.push_back({middle, side(1), quad[2], side(2)});
        result.quads.push_back({side(3), middle, side(2), quad[3]});
    }
    for (int e = 0; e < edges; ++e) {
        const auto& edge = mesh.edges[index(e)];
        for (const int end : edge)
            addTo(edgePoints[e], mesh.sharp[index(e)] ? 0.5 : 0.25, mesh.points[index(end)]);
        if (mesh.sharp[index(e)]) result.rules[index(vertices + e)].along = edge;
    }
    const Stars stars(mesh);
    for (int v = 0; v < vertices; ++v) {
        const Rule& rule = mesh.rules[index(v)];
        Place& point = result.points[index(v)];
        const double n = stars.valence[index(v)];
        if (rule.isSmooth() && n > 0) {
            // The mean of the quads' centres includes near and far corners: (v n + 2 near + far) / 4n.
            addTo(point, (n - 3) / n + 1 / n + 1 / (4 * n), mesh.points[index(v)]);
            addTo(point, 1 / (n * n) + 2 / (4 * n * n), stars.near[index(v)]);
            addTo(point, 1 / (4 * n * n), stars.far[index(v)]);
        } else {
            addTo(point, 6.0 / 8, mesh.points[index(v)]);
            for (const int neighbour : n > 0 ? rule.along : std::array<int, 2>{v, v})
                addTo(point, 1.0 / 8, mesh.points[index(neighbour)]);
        }
        result.rules[index(v)] = rule;
    }
    // The next neighbours along a crease are the points on its edges, and the halves of sharp edges are
    // sharp.
    for (int e = 0; e < edges; ++e) {
        const auto& edge = mesh.edges[index(e)];
        for (std::size_t k = 0; k < 2; ++k) {
            const Rule& before = mesh.rules[index(edge[k])];
            Rule& rule = result.rules[index(edge[k])];
            for (std::size_t side = 0; side < 2; ++side)
                if (before.along[side] == edge[1 - k]) rule.along[side] = vertices + e;
            if (before.end == edge[1 - k]) rule.end = vertices + e;
        }
    }
    findEdges(result);
    for (const auto& half : result.edges) {
        const bool isHalf = half[0] < vertices && half[1] < vertices + edges;
        result.sharp.push_back(isHalf && mesh.sharp[index(half[1] - vertices)] ? 1 : 0);
    }
    return result;
}

/// Finds the curve of sharp edges through each vertex, if there is one.
class Rules {
public:
    Rules(const CheckedMesh& mesh, const Neighbourhoods& around, const std::vector<char>& sharp,
          const LayoutPart& layout)
        : mesh_(mesh), around_(around), sharp_(sharp), straightest_(mesh.points.size(), HUGE_VAL),
          passing_(mesh.points.size()) {
        for (const auto& segment : layout.segments)
            for (const auto& side : segment.sides)
                for (std::size_t i = 1; i + 1 < side.size(); ++i)
                    pass(side[i - 1], side[i], side[i + 1]);
    }

    [[nodiscard]] Rule of(int vertex) const {
        std::vector<int> ranks;
        const int first = around_.firstStep(vertex);
        const int valence = around_.valence(vertex);
        for (int k = 0; k < valence; ++k)
            if (isSharp(first + k)) ranks.push_back(k);
        if (ranks.empty()) return {};
        if (ranks.size() == 1) return {{-1, -1}, around_.to(first + ranks[0])};
        if (straightest_[index(vertex)] < HUGE_VAL) return passing_[index(vertex)];
        const Rule corner{{vertex, vertex}, -1};
        if (ranks.size() > 2) return corner;
        const int between = ranks[1] - ranks[0];
        const bool closed = around_.interior(vertex);
        if (between < 2 || (closed && valence - between < 2)) return corner;
        const int a = around_.to(first + ranks[0]);
        const int b = around_.to(first + ranks[1]);
        constexpr double maxTurn = 1.2; // radians
        const bool straight =
            turn(mesh_.points[index(a)], mesh_.points[index(vertex)], mesh_.points[index(b)]) <= maxTurn;
        return straight ? Rule{{a, b}, -1} : corner;
    }

private:
    [[nodiscard]] bool isSharp(int step) const {
        return around_.boundary(step) || sharp_[index(around_.edge(step))] != 0;
    }

    /// Notes that a side of a segment passes a vertex, from a to b.
    void pass(int a, int vertex, int b) {
        if (!isSharp(around_.stepBetween(vertex, a)) || !isSharp(around_.stepBetween(vertex, b))) return;
        const double angle =
            turn(mesh_.points[index(a)], mesh_.points[index(vertex)], mesh_.points[index(b)]);
        if (angle >= straightest_[index(vertex)] - 1e-12) return;
        straightest_[index(vertex)] = angle;
        passing_[index(vertex)].along = {a, b};
    }

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    const std::vector<char>& sharp_;
    std::vector<double> straightest_;
    std::vector<Rule> passing_;
};

/// Moves the vertices until their limits are at the vertices of the mesh.
void interpolate(Mesh& mesh) {
    const std::vector<Place> targets = mesh.points;
    constexpr int rounds = 300;
    constexpr double relaxation = 1.5; // all eigenvalues of the limit masks lie between 1/9 and 1
    for (int round = 0; round < rounds; ++round) {
        const auto reached = limits(mesh);
        for (std::size_t v = 0; v < targets.size(); ++v)
            addTo(mesh.points[v], relaxation, minus(targets[v], reached[v]));
    }
}

} // namespace

LimitLattices limitThroughVertices(const CheckedMesh& mesh, const Neighbourhoods& around,
                                   const std::vector<char>& sharp, const LayoutPart& layout) {
    Mesh control;
    control.points = mesh.points;
    control.quads = mesh.quads;
    const Rules rules(mesh, around, sharp, layout);
    for (int v = 0; v < around.vertices(); ++v)
        control.rules.push_back(rules.of(v));
    findEdges(control);
    for (const auto& edge : control.edges) {
        const int step = around.stepBetween(edge[0], edge[1]);
        control.sharp.push_back(around.boundary(step) || sharp[index(around.edge(step))] ? 1 : 0);
    }
    interpolate(control);
    for (int level = 0; level < levels; ++level)
        control = subdivided(control);
    const auto points = limits(control);

    // Quad q of a level has the children 4 q ... 4 q + 3, in the order of its corners.
    LimitLattices lattices(mesh.quads.size(), std::vector<Place>(latticeSize));
    constexpr std::size_t children = std::size_t{1} << (2 * levels);
    for (std::size_t q = 0; q < control.quads.size(); ++q) {
        std::size_t column = 0;
        std::size_t row = 0;
        for (int level = 0; level < levels; ++level) {
            const std::size_t corner = q >> (2 * level) & 3U;
            column += (corner == 1 || corner == 2 ? 1U : 0U) << level;
            row += (corner >= 2 ? 1U : 0U) << level;
        }
        auto& lattice = lattices[q / children];
        const std::size_t first = row * (perQuad + 1) + column;
        const std::array<std::size_t, 4> at{first, first + 1, first + perQuad + 2, first + perQuad + 1};
        for (std::size_t k = 0; k < 4; ++k)
            lattice[at[k]] = points[index(control.quads[q][k])];
    }
    return lattices;
}

} // namespace measure
