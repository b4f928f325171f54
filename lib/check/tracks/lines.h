/// \file Separatrices, traced anew, with their junctions and coordinates (docs/METHOD.md#base-complex).
#pragma once

#include "base/at.h"
#include "check/mesh/neighbourhoods.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace qm::check {

/// The directed path of one particle: from its source straight on to an extraordinary vertex, the boundary, a
/// seed of its own line, or the first vertex outside its sub-mesh. It is not cut short where it crosses
/// itself: rule A2 stops the particle there.
struct Way {
    std::vector<int> steps; ///< at least one
    int opposite = -1;      ///< the same path backwards, if a particle starts at its end
    /// Steps up to the first vertex that it visits twice: no particle gets past its own track.
    int reach = 0;
    int candidateStops = 1; ///< junctions before its reach, and the end of it
    /// The junctions on it, in order, without its ends; `stopSteps` has the number of steps up to each.
    std::vector<int> stops;
    std::vector<int> stopSteps;

    [[nodiscard]] bool selfCrossing() const { return reach < static_cast<int>(steps.size()); }
    /// In arcs, as coordinates count.
    [[nodiscard]] int length() const { return static_cast<int>(stops.size()) + 1; }
    /// The number of steps to coordinate x.
    [[nodiscard]] int stepsTo(int x) const {
        if (x == length()) return static_cast<int>(steps.size());
        return x == 0 ? 0 : stopSteps[at(x) - 1];
    }
};

/// The way that reaches a junction from one side, and the junction's coordinate on it.
struct Arrival {
    int way = -1; ///< none comes from there if negative
    int coordinate = 0;
};

/// A regular vertex where two lines cross. `from[i]` comes in along the vertex's step i: opposite sides, i
/// and i + 2, are one line.
struct Crossing {
    int vertex = -1;
    std::array<Arrival, 4> from;
    /// A feature seed: the line without arrivals starts here, in both directions.
    bool seeded = false;
};

/// All lines that were traced together, from the sources of one mesh or sub-mesh.
struct LineNetwork {
    std::vector<Way> ways;           ///< ordered by source vertex, then by its steps
    std::vector<Crossing> crossings; ///< ascending by vertex
    std::unordered_map<int, int> wayByFirstStep;
    /// n_j: regular vertices where lines cross or end at their own track, within the reach of the particles.
    std::size_t ordinaryJunctions = 0;
};

/// What starts and stops particles besides extraordinary vertices.
struct TraceInput {
    /// One step at every seed, along its line; no two at one vertex, and all at passable vertices.
    std::vector<int> seedSteps;
    std::vector<int> labels; ///< sub-mesh of every vertex; empty for the whole mesh
    int subMeshes = 1;
};

/// One network per sub-mesh, linear in the mesh all together: a way belongs to the sub-mesh of its source.
[[nodiscard]] std::vector<LineNetwork> traceLines(const Neighbourhoods& around, const TraceInput& input);

/// The junction where way `w` has coordinate x (0 < x < length), and the side that it comes from.
struct Meeting {
    const Crossing* crossing;
    std::size_t side;
    [[nodiscard]] const Arrival& left() const { return crossing->from[(side + 3) % 4]; }
    [[nodiscard]] const Arrival& right() const { return crossing->from[(side + 1) % 4]; }
};
[[nodiscard]] Meeting meetingAt(const LineNetwork& network, int way, int x);

/// Quasi-complexity U: the sum over the ways of log2 of their candidate stops (docs/METHOD.md#mesh-cut).
[[nodiscard]] double quasiComplexity(const LineNetwork& network);

} // namespace qm::check
