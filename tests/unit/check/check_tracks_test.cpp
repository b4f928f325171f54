// Tracks moved such that they break one rule after another (docs/METHOD.md#valid-tracks).
#include "base/at.h"
#include "support/polycube.h"
#include "support/true_models.h"

#include <gtest/gtest.h>

namespace qm::test {
namespace {

using namespace check;

TEST(CheckTracks, SeesATrackThatStopsBetweenJunctions) {
    Model model = make(polycube(box(1, 1, 1), 3));
    layout(model.document).tracks[0].vertices.pop_back();
    EXPECT_TRUE(found(checkDocument(model.mesh, model.document), "/layout/tracks/0/vertices/2", "A4"));
}

TEST(CheckTracks, SeesATrackThatLeavesItsLine) {
    Model model = twoHolesModel();
    auto& track = crashing(model.document);
    const std::string pointer = "/layout/tracks/" + std::to_string(*track.id) + "/vertices/";
    const Neighbourhoods around(model.mesh);
    const int end = track.vertices.back();
    for (int i = 0; i < 4; ++i) {
        const int other = around.to(around.firstStep(end) + i);
        if (other == track.vertices[track.vertices.size() - 2] ||
            other == around.to(around.straightOn(
                         around.stepBetween(track.vertices[track.vertices.size() - 2], end))))
            continue;
        track.vertices.push_back(other);
        break;
    }
    EXPECT_TRUE(found(checkDocument(model.mesh, model.document),
                      pointer + std::to_string(track.vertices.size() - 1), "track straight"));
}

TEST(CheckTracks, SeesATrackThatPassesThroughAnother) {
    Model model = twoHolesModel();
    auto& track = crashing(model.document);
    const Neighbourhoods around(model.mesh);
    int step = around.stepBetween(track.vertices[track.vertices.size() - 2], track.vertices.back());
    while (around.passable(around.to(step))) {
        step = around.straightOn(step);
        track.vertices.push_back(around.to(step));
    }
    const Report report = checkDocument(model.mesh, model.document);
    EXPECT_TRUE(found(report, "/layout/tracks/" + std::to_string(*track.id), "A2"));
    EXPECT_TRUE(found(report, "/layout/tracks", "arc rule 4"));
}

TEST(CheckTracks, LetsAPrunedLayoutLackTracks) {
    // The hole of a frame gives eight tracks; without two opposite ones all segments are still grids.
    Model model = make(plane({"xxx", "x.x", "xxx"}));
    model.document.surfaces.reset();
    LayoutPart& part = layout(model.document);
    const auto gone = part.tracks[0];
    part.tracks.erase(part.tracks.begin());
    for (std::size_t i = 0; i < part.tracks.size(); ++i)
        part.tracks[i].id = static_cast<int>(i);
    *part.cost -= *gone.cost;
    const Neighbourhoods around(model.mesh);
    std::vector<char> border(static_cast<std::size_t>(around.edges()), 0);
    for (const auto& track : part.tracks)
        for (std::size_t i = 1; i < track.vertices.size(); ++i)
            border[at(around.edge(around.stepBetween(track.vertices[i - 1], track.vertices[i])))] = 1;
    part.segments = segmentsBetween(model.mesh, around, border);
    part.lowerBound = *part.cost + 1;
    part.pruned = true;
    const Report pruned = checkDocument(model.mesh, model.document);
    EXPECT_TRUE(pruned.ok()) << listed(pruned);

    part.pruned = false;
    const Report merged = checkDocument(model.mesh, model.document);
    EXPECT_TRUE(found(merged, "/layout/tracks", "A3"));
    EXPECT_TRUE(found(merged, "/layout/tracks", "arc rule 1"));
    EXPECT_TRUE(found(merged, "/layout/lowerBound", "bound"));

    part.pruned = true;
    part.tracks[0].vertices = {0, 1};
    EXPECT_TRUE(
        found(checkDocument(model.mesh, model.document), "/layout/tracks/0/vertices/0", "track inside"));
    const auto& path = part.tracks[1].vertices; // there and back
    part.tracks[0].vertices = {path[0], path[1], path[0]};
    EXPECT_TRUE(
        found(checkDocument(model.mesh, model.document), "/layout/tracks/0/vertices/1", "track straight"));
}

} // namespace
} // namespace qm::test
