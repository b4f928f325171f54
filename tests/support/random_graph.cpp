#include "support/random_graph.h"

#include "base/at.h"
#include "base/error.h"
#include "enumerate/state/search_state.h"
#include "mesh/soup/build_mesh.h"
#include "mesh/topology.h"
#include "support/polycube.h"

#include <algorithm>
#include <queue>

namespace qm::test {

namespace {

int draw(std::mt19937& random, int min, int max) {
    return std::uniform_int_distribution(min, max)(random);
}

check::CheckedMesh randomCubes(std::mt19937& random) {
    Cells cells;
    const int density = draw(random, 3, 9);
    for (const auto& cell : box(3, 3, 2))
        if (draw(random, 0, 9) < density) cells.push_back(cell);
    return polycube(cells, draw(random, 1, 3));
}

check::CheckedMesh randomPlane(std::mt19937& random) {
    std::vector<std::string> rows(6, std::string(7, 'x'));
    for (std::string& row : rows)
        for (char& square : row)
            if (draw(random, 0, 5) == 0) square = '.';
    std::vector<const char*> texts;
    texts.reserve(rows.size());
    for (const std::string& row : rows)
        texts.push_back(row.c_str());
    return plane(texts);
}

check::CheckedMesh randomGlued(std::mt19937& random) {
    const int squares = draw(random, 1, 5);
    std::vector<int> sides(static_cast<std::size_t>(4 * squares));
    for (std::size_t s = 0; s < sides.size(); ++s)
        sides[s] = static_cast<int>(s);
    std::shuffle(sides.begin(), sides.end(), random);
    std::vector<std::array<int, 2>> pairs;
    const bool isOpen = draw(random, 0, 1) == 1;
    const int open = draw(random, 0, squares) * (isOpen ? 1 : 0);
    for (std::size_t s = 0; s + 1 < sides.size() - static_cast<std::size_t>(2 * open); s += 2)
        pairs.push_back({sides[s], sides[s + 1]});
    return glued(squares, pairs, draw(random, 2, 4));
}

} // namespace

QuadMesh quadMesh(const check::CheckedMesh& mesh) {
    std::vector<Point> points;
    for (const auto& point : mesh.points)
        points.emplace_back(point[0], point[1], point[2]);
    return buildMesh(points, mesh.quads);
}

std::optional<QuadMesh> randomMesh(std::mt19937& random) {
    // Compilers evaluate arguments in different orders: numbers that are arguments are drawn before.
    try {
        switch (draw(random, 0, 9)) {
        case 0: {
            const int around = draw(random, 3, 6), along = draw(random, 3, 6);
            return quadMesh(torus(around, along));
        }
        case 1: {
            const int around = draw(random, 3, 6), along = draw(random, 1, 6);
            return quadMesh(tube(around, along));
        }
        case 2:
        case 3:
            return quadMesh(randomCubes(random));
        case 4:
        case 5:
            return quadMesh(randomPlane(random));
        default:
            return quadMesh(randomGlued(random));
        }
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::vector<Seed> randomSeeds(const QuadMesh& mesh, std::size_t max, std::mt19937& random) {
    std::vector<VertexId> places;
    for (const VertexId vertex : mesh.vertices())
        if (!mesh.is_isolated(vertex) && continuesStraight(mesh, vertex)) places.push_back(vertex);
    std::shuffle(places.begin(), places.end(), random);
    places.resize(std::min(places.size(), static_cast<std::size_t>(draw(random, 0, static_cast<int>(max)))));
    std::vector<Seed> seeds;
    for (const VertexId vertex : places) {
        HalfedgeId direction = mesh.halfedge_handle(vertex);
        if (draw(random, 0, 1) == 1) direction = mesh.ccw_rotated_halfedge_handle(direction);
        seeds.push_back({direction});
    }
    return seeds;
}

std::vector<Track> randomGraph(const QuadMesh& mesh, const BaseComplex& complex,
                               const std::vector<double>& edgeCosts, std::mt19937& random) {
    std::vector<bool> visited(mesh.n_vertices()), covered(mesh.n_edges());
    IdVector<SeparatrixId, Track> tracks(complex.separatrices.size());
    using Departure = std::pair<double, SeparatrixId>;
    std::priority_queue<Departure, std::vector<Departure>, std::greater<>> departures;
    std::exponential_distribution<double> pause(1);
    for (const SeparatrixId id : complex.separatrices.ids()) {
        visited[at(mesh.from_vertex_handle(complex.separatrices[id].halfedges.front()))] = true;
        departures.emplace(pause(random), id);
    }
    while (!departures.empty()) {
        const auto [time, id] = departures.top();
        departures.pop();
        const auto& path = complex.separatrices[id].halfedges;
        const HalfedgeId next = path[tracks[id].halfedges.size()];
        if (covered[at(mesh.edge_handle(next))]) continue;
        covered[at(mesh.edge_handle(next))] = true;
        tracks[id].halfedges.push_back(next);
        tracks[id].cost += edgeCosts[at(mesh.edge_handle(next))];
        const VertexId vertex = mesh.to_vertex_handle(next);
        if (!visited[at(vertex)] && tracks[id].halfedges.size() < path.size())
            departures.emplace(time + pause(random), id);
        visited[at(vertex)] = true;
    }
    std::erase_if(tracks, [](const Track& track) { return track.halfedges.empty(); });
    return tracks;
}

bool isMotorcycleGraph(const ArcGraph& graph, const PresentArcs& present) {
    const IdVector<ArcId, double> costs(graph.arcs.size(), 0);
    const Problem problem = makeProblem({graph, costs, {}, {}, {}, {}});
    SearchState state(problem);
    if (!state.consistent()) return false;
    for (const VariableId v : problem.variables()) {
        const ArcRun& run = problem.arcs[v];
        const bool in = present[run.first];
        for (int k = 1; k < run.count; ++k)
            if (present[run.first + k] != in) return false;
        if (!state.assign(v, arcState(in))) return false;
    }
    return true;
}

} // namespace qm::test
