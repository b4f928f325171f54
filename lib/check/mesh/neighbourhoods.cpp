#include "check/mesh/neighbourhoods.h"

#include "base/error.h"
#include "base/positions.h"

#include <algorithm>
#include <string>

namespace qm::check {

namespace {

[[noreturn]] void badVertex(int vertex, const std::string& what) {
    throw Error("vertex " + std::to_string(vertex), what, "Give a quad mesh that is an oriented 2-manifold");
}

void requireQuads(const CheckedMesh& mesh) {
    const int vertices = static_cast<int>(mesh.points.size());
    for (std::size_t face = 0; face < mesh.quads.size(); ++face) {
        auto corners = mesh.quads[face];
        std::ranges::sort(corners);
        const bool different = std::ranges::adjacent_find(corners) == corners.end();
        if (!different || corners.front() < 0 || corners.back() >= vertices)
            throw Error("face " + std::to_string(face), "not a quad of four different vertices",
                        "Give a quad mesh");
    }
}

} // namespace

Neighbourhoods::Neighbourhoods(const CheckedMesh& mesh) {
    requireQuads(mesh);
    faces_ = static_cast<int>(mesh.quads.size());
    const std::size_t vertexCount = mesh.points.size();

    // The corners of every vertex, sorted into one array by counting.
    std::vector<int> begin(vertexCount + 1, 0);
    for (const auto& quad : mesh.quads)
        for (const int vertex : quad)
            ++begin[at(vertex) + 1];
    for (std::size_t v = 0; v < vertexCount; ++v)
        begin[v + 1] += begin[v];
    std::vector<Corner> corners(mesh.quads.size() * 4);
    std::vector<int> filled(begin.begin(), begin.end() - 1);
    for (int face = 0; face < faces_; ++face) {
        const auto& quad = mesh.quads[at(face)];
        for (std::size_t i = 0; i < 4; ++i)
            corners[at(filled[at(quad[i])]++)] = {quad[(i + 1) % 4], quad[(i + 3) % 4],
                                                  4 * face + static_cast<int>(i)};
    }

    stepOfSide_.resize(corners.size());
    first_.push_back(0);
    closed_.reserve(vertexCount);
    for (std::size_t v = 0; v < vertexCount; ++v)
        addFan(static_cast<int>(v), std::span(corners).subspan(at(begin[v]), at(begin[v + 1] - begin[v])));
    pairSteps(mesh);
}

void Neighbourhoods::addFan(int vertex, std::span<Corner> corners) {
    std::ranges::sort(corners, {}, &Corner::next);
    const std::vector<int> following = followingCorners(vertex, corners);
    std::vector<char> hasBefore(corners.size(), 0);
    for (const int corner : following)
        if (corner >= 0) hasBefore[at(corner)] = 1;
    // An open fan begins at the only corner that no other comes before.
    const auto start = std::ranges::find(hasBefore, 0);
    const bool closed = start == hasBefore.end();
    const int first = closed ? 0 : static_cast<int>(start - hasBefore.begin());
    std::size_t walked = 0;
    for (int corner = corners.empty() ? -1 : first; corner >= 0;) {
        const Corner& here = corners[at(corner)];
        stepOfSide_[at(here.side)] = static_cast<int>(to_.size());
        to_.push_back(here.next);
        left_.push_back(here.side / 4);
        ++walked;
        corner = following[at(corner)];
        if (corner < 0) {
            to_.push_back(here.previous);
            left_.push_back(-1);
        }
        if (corner == first) break;
    }
    if (walked != corners.size()) badVertex(vertex, "its faces form more than one fan");
    closed_.push_back(closed);
    first_.push_back(static_cast<int>(to_.size()));
}

std::vector<int> Neighbourhoods::followingCorners(int vertex, std::span<const Corner> corners) {
    std::vector<int> following(corners.size(), -1);
    std::vector<char> hasBefore(corners.size(), 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i > 0 && corners[i - 1].next == corners[i].next)
            badVertex(vertex, "two faces leave it along the same edge in the same direction");
        const auto after = std::ranges::lower_bound(corners, corners[i].previous, {}, &Corner::next);
        if (after == corners.end() || after->next != corners[i].previous) continue;
        const std::size_t place = positionIn(corners, after);
        if (hasBefore[place]) badVertex(vertex, "two faces reach it along the same edge");
        hasBefore[place] = 1;
        following[i] = static_cast<int>(place);
    }
    return following;
}

void Neighbourhoods::pairSteps(const CheckedMesh& mesh) {
    back_.assign(to_.size(), -1);
    edge_.assign(to_.size(), -1);
    // In the face to the left of a step, the corner that it leads to lies just clockwise of the way back.
    for (std::size_t side = 0; side < stepOfSide_.size(); ++side) {
        const std::size_t corner = side / 4 * 4 + (side + 1) % 4;
        const int vertex = mesh.quads[corner / 4][corner % 4];
        const int step = stepOfSide_[side];
        const int beside = stepOfSide_[corner];
        const int other = firstStep(vertex) + (beside - firstStep(vertex) + 1) % valence(vertex);
        back_[at(step)] = other;
        back_[at(other)] = step;
        if (edge_[at(step)] >= 0) continue;
        edge_[at(step)] = edge_[at(other)] = edges_++;
    }
}

bool Neighbourhoods::regular(int vertex) const {
    if (valence(vertex) == 0) return true;
    return interior(vertex) ? valence(vertex) == 4 : valence(vertex) <= 3;
}

int Neighbourhoods::stepBetween(int fromVertex, int toVertex) const {
    // Looked for on the side with fewer neighbours, so that a hub of many edges costs nothing.
    const bool swap = valence(toVertex) < valence(fromVertex);
    const int here = swap ? toVertex : fromVertex;
    const int there = swap ? fromVertex : toVertex;
    const auto begin = to_.begin() + firstStep(here);
    const auto found = std::find(begin, begin + valence(here), there);
    if (found == begin + valence(here)) return -1;
    const int step = static_cast<int>(found - to_.begin());
    return swap ? back(step) : step;
}

int Neighbourhoods::turn(int step, int quarters) const {
    const int first = firstStep(from(step));
    return first + (step - first + quarters) % 4;
}

} // namespace qm::check
