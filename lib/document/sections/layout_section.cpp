#include "document/sections/layout_section.h"

#include "base/at.h"
#include "base/error.h"
#include "document/sections/mesh_paths.h"
#include "layout/quality.h"
#include "layout/tracks.h"

namespace qm {

namespace {

Json tracksToJson(const QuadMesh& mesh, const Layout& layout) {
    Json::array_t tracks;
    for (const LayoutTrack& entry : layout.tracks) {
        tracks.push_back({{"id", tracks.size()},
                          {"vertices", pathNumbers(mesh, entry.track.halfedges)},
                          {"cost", entry.track.cost}});
        if (entry.transversal) tracks.back()["transversal"] = true;
    }
    return tracks;
}

Json segmentToJson(const Segment& segment, std::size_t id) {
    Json::array_t sides;
    for (const std::vector<VertexId>& side : segment.sides)
        sides.push_back(numbersOf(side));
    return {{"id", id},
            {"size", segment.size},
            {"corners", numbersOf(segment.corners)},
            {"sides", std::move(sides)},
            {"faces", numbersOf(segment.faces)}};
}

Json segmentsToJson(const Layout& layout) {
    Json::array_t segments;
    for (const Segment& segment : layout.segments)
        segments.push_back(segmentToJson(segment, segments.size()));
    return segments;
}

} // namespace

Json layoutToJson(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                  double rho) {
    const LayoutQuality quality = measureLayout(mesh, layout, dihedralAngles, rho);
    return {{"cost", layout.cost},
            {"lowerBound", valueOrNull(layout.lowerBound)},
            {"tracks", tracksToJson(mesh, layout)},
            {"segments", segmentsToJson(layout)},
            {"quality",
             {{"rho", rho},
              {"segments", quality.segments},
              {"tJoints", quality.tJoints},
              {"capturedSharpness", quality.capturedSharpness},
              {"medianAspect", quality.medianAspect},
              {"maxAspect", quality.maxAspect},
              {"gap", layout.lowerBound ? Json(layout.cost - *layout.lowerBound) : Json()}}}};
}

Json mergeFigures(const MergeResult& result) {
    return {{"rounds", result.rounds},
            {"searches", result.searches},
            {"freeAfterPartial", result.freeAfterPartial},
            {"linked", result.linked},
            {"extended", result.extended},
            {"plain", result.plain},
            {"costBefore", result.costBefore},
            {"windows", result.windows},
            {"improvements", result.improvements}};
}

Json pruneFigures(const PruneResult& result) {
    Json front = Json::array();
    for (const FrontPoint& point : result.front)
        front.push_back({{"beta", point.beta},
                         {"segments", point.segments},
                         {"cost", point.cost},
                         {"capturedSharpness", point.capturedSharpness},
                         {"objectiveBound", point.objectiveBound},
                         {"proven", point.proven}});
    return {{"addedTracks", result.addedTracks},
            {"removedTracks", result.removedTracks},
            {"keptNotQuadrilateral", result.keptNotQuadrilateral},
            {"keptNotSmooth", result.keptNotSmooth},
            {"objectiveBound", valueOrNull(result.objectiveBound)},
            {"proven", result.proven},
            {"front", std::move(front)}};
}

namespace {

/// Reads the tracks and checks their costs; no edge may lie on two tracks or on the boundary.
std::vector<LayoutTrack> readTracks(const QuadMesh& mesh, const std::vector<double>& edgeCosts,
                                    const JsonPlace& list) {
    verifyDistinctIds(list);
    std::vector<LayoutTrack> tracks;
    std::vector<bool> taken(mesh.n_edges());
    for (const JsonPlace& place : list.elements()) {
        const JsonPlace vertices = place["vertices"];
        LayoutTrack entry{trackOf(mesh, pathAt(mesh, vertices), edgeCosts), false};
        for (std::size_t k = 0; k < entry.track.halfedges.size(); ++k) {
            const EdgeId edge = mesh.edge_handle(entry.track.halfedges[k]);
            if (mesh.is_boundary(edge))
                vertices.failAt(k + 1, "the edge to this vertex is on the mesh boundary");
            if (taken[at(edge)]) vertices.failAt(k + 1, "the edge to this vertex lies on a track already");
            taken[at(edge)] = true;
        }
        requireStraight(mesh, entry.track.halfedges, vertices);
        verifyCost(place, entry.track.cost);
        if (const auto transversal = place.find("transversal")) entry.transversal = transversal->boolean();
        tracks.push_back(std::move(entry));
    }
    return tracks;
}

Layout divide(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
              const std::vector<double>& edgeCosts, const std::vector<LayoutTrack>& tracks,
              const JsonPlace& place) {
    std::vector<Track> plain;
    plain.reserve(tracks.size());
    for (const LayoutTrack& entry : tracks)
        plain.push_back(entry.track);
    Layout layout;
    try {
        layout = buildLayout(mesh, plain, dihedralAngles, edgeCosts);
    } catch (const Error& error) {
        place.fail(std::string("do not cut the mesh into grids: ") + error.what());
    }
    for (std::size_t i = 0; i < tracks.size(); ++i)
        layout.tracks[i].transversal = tracks[i].transversal;
    layout.cost = 0;
    for (const LayoutTrack& entry : layout.tracks)
        if (!entry.transversal) layout.cost += entry.track.cost;
    return layout;
}

} // namespace

Layout readLayout(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                  const std::vector<double>& edgeCosts, const JsonPlace& section) {
    const JsonPlace trackList = section["tracks"];
    const std::vector<LayoutTrack> tracks = readTracks(mesh, edgeCosts, trackList);
    Layout layout = divide(mesh, dihedralAngles, edgeCosts, tracks, trackList);
    verifyCost(section, layout.cost);
    if (const auto bound = section.find("lowerBound")) layout.lowerBound = bound->numberOrNull();
    if (const auto segments = section.find("segments"))
        segments->requireEqual(segmentsToJson(layout), "is not what follows from the tracks",
                               "Delete " + segments->pointer().to_string() +
                                   " and the segments are made anew");
    return layout;
}

bool layoutIsWhole(const QuadMesh& mesh, const Layout& layout, const Json& section) {
    return section.contains("cost") && section.contains("segments") &&
           !firstDifference(tracksToJson(mesh, layout), section.at("tracks"));
}

} // namespace qm
