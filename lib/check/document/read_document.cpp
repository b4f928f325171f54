#include "check/document/read_document.h"

#include "check/document/check_history.h"
#include "check/document/json_values.h"

#include <algorithm>

namespace qm::check {

namespace {

std::vector<std::vector<int>> readPaths(const Json& list) {
    return all<std::vector<int>>(list, [](const Json& path) { return wholes(member(path, "vertices")); });
}

BaseComplexPart readBaseComplex(const Json& section) {
    BaseComplexPart part;
    part.extraordinaryVertices = wholes(member(section, "extraordinaryVertices"));
    part.ordinaryJunctions = whole(member(section, "ordinaryJunctions"));
    part.separatrices =
        all<BaseComplexPart::Separatrix>(member(section, "separatrices"), [](const Json& separatrix) {
            return BaseComplexPart::Separatrix{
                whole(member(separatrix, "id")), wholes(member(separatrix, "vertices")),
                wholeIfAny(member(separatrix, "opposite")), isTrue(member(separatrix, "selfCrossing"))};
        });
    return part;
}

FeaturesPart readFeatures(const Json& section) {
    return {all<FeaturesPart::Curve>(member(section, "curves"), [](const Json& curve) {
        return FeaturesPart::Curve{whole(member(curve, "id")), wholes(member(curve, "vertices")),
                                   whole(member(curve, "seed"))};
    })};
}

CutPart readCut(const Json& section) {
    CutPart part;
    part.labels = wholes(member(section, "labels"));
    part.subMeshes = all<CutPart::SubMesh>(member(section, "subMeshes"), [](const Json& subMesh) {
        return CutPart::SubMesh{whole(member(subMesh, "id")), number(member(subMesh, "quasiComplexity")),
                                wholeIfAny(member(subMesh, "ordinaryJunctions")),
                                wholeIfAny(member(subMesh, "source")), wholeIfAny(member(subMesh, "sink"))};
    });
    return part;
}

TrackPart readTrack(const Json& track) {
    return {wholeIfAny(member(track, "id")),     wholeIfAny(member(track, "separatrix")),
            wholeIfAny(member(track, "source")), wholes(member(track, "vertices")),
            number(member(track, "cost")),       isTrue(member(track, "transversal"))};
}

EnumerationPart readEnumeration(const Json& section) {
    const auto readGraph = [](const Json& graph) {
        return EnumerationPart::Graph{number(member(graph, "cost")),
                                      all<TrackPart>(member(graph, "tracks"), readTrack)};
    };
    EnumerationPart part;
    part.tmesh = text(member(section, "class")) == "tmesh";
    part.count = text(member(section, "count"));
    part.subMeshes = all<EnumerationPart::SubMesh>(member(section, "subMeshes"), [&](const Json& subMesh) {
        return EnumerationPart::SubMesh{whole(member(subMesh, "id")),
                                        number(member(subMesh, "cost")),
                                        number(member(subMesh, "lowerBound")),
                                        text(member(subMesh, "count")),
                                        all<EnumerationPart::Graph>(member(subMesh, "graphs"), readGraph),
                                        all<EnumerationPart::Graph>(member(subMesh, "samples"), readGraph)};
    });
    return part;
}

CostWeights readWeights(const Json& section) {
    CostWeights weights{numberOrNan(member(section, "alpha")), numberOrNan(member(section, "epsilon"))};
    const Json& terms = member(section, "terms");
    const auto read = [&](const char* name, double& weight) {
        if (!member(terms, name).is_null()) weight = numberOrNan(member(terms, name));
    };
    read("dihedral", weights.dihedral);
    read("length", weights.length);
    read("segments", weights.segments);
    read("custom", weights.custom);
    return weights;
}

ConstraintsPart::Weight readWeight(const Json& entry) {
    return {wholes(member(entry, "vertices")), numberOrNan(member(entry, "weight"))};
}

LayoutPart::Segment readSegment(const Json& segment) {
    LayoutPart::Segment part;
    part.id = whole(member(segment, "id"));
    for (std::size_t k = 0; k < 2; ++k)
        part.size[k] = whole(element(member(segment, "size"), k));
    for (std::size_t k = 0; k < 4; ++k) {
        part.corners[k] = whole(element(member(segment, "corners"), k));
        part.sides[k] = wholes(element(member(segment, "sides"), k));
    }
    part.faces = wholes(member(segment, "faces"));
    return part;
}

LayoutPart::FrontPoint readFrontPoint(const Json& point) {
    return {numberOrNan(member(point, "beta")),      numberOrNan(member(point, "segments")),
            numberOrNan(member(point, "cost")),      numberOrNan(member(point, "capturedSharpness")),
            number(member(point, "objectiveBound")), isTrue(member(point, "proven"))};
}

LayoutPart readLayout(const Json& section) {
    LayoutPart part;
    part.cost = number(member(section, "cost"));
    part.lowerBound = number(member(section, "lowerBound"));
    part.tracks = all<TrackPart>(member(section, "tracks"), readTrack);
    part.divided = member(section, "segments").is_array();
    part.segments = all<LayoutPart::Segment>(member(section, "segments"), readSegment);
    const Json& quality = member(section, "quality");
    part.quality = {number(member(quality, "rho")),          number(member(quality, "segments")),
                    number(member(quality, "tJoints")),      number(member(quality, "capturedSharpness")),
                    number(member(quality, "medianAspect")), number(member(quality, "maxAspect")),
                    number(member(quality, "gap"))};
    part.front = all<LayoutPart::FrontPoint>(member(member(section, "prune"), "front"), readFrontPoint);
    return part;
}

SurfacesPart::Figures readFigures(const Json& deviation) {
    SurfacesPart::Figures figures;
    if (deviation.is_object())
        for (const auto& [name, value] : deviation.items())
            if (const auto figure = number(value)) figures.stated.emplace(name, *figure);
    return figures;
}

SurfacesPart::Patch readPatch(const Json& patch) {
    SurfacesPart::Patch part;
    part.segment = whole(member(patch, "segment"));
    for (std::size_t k = 0; k < 2; ++k) {
        part.degree[k] = whole(element(member(patch, "degree"), k));
        part.knots[k] = all<double>(element(member(patch, "knots"), k), numberOrNan);
    }
    const Json& rows = member(patch, "controlPoints");
    const std::size_t width = elements(element(rows, 0)).size();
    part.count = {static_cast<int>(width), static_cast<int>(elements(rows).size())};
    for (const Json& row : elements(rows)) {
        part.rectangular = part.rectangular && elements(row).size() == width;
        for (const Json& point : elements(row))
            part.controlPoints.push_back({numberOrNan(element(point, 0)), numberOrNan(element(point, 1)),
                                          numberOrNan(element(point, 2))});
    }
    part.figures = readFigures(member(patch, "deviation"));
    return part;
}

/// The options of the last tool of this name in the history; null if it took no part.
const Json& optionsOf(const Json& root, const char* tool) {
    static const Json none;
    const auto& history = elements(member(root, "history"));
    const auto last = std::find_if(history.rbegin(), history.rend(),
                                   [&](const Json& entry) { return text(member(entry, "tool")) == tool; });
    return last == history.rend() ? none : member(*last, "options");
}

SurfacesPart::Claim readClaim(const Json& place) {
    SurfacesPart::Claim claim{whole(member(place, "patch")), {}, {}};
    for (std::size_t k = 0; k < 2; ++k)
        claim.at[k] = numberOrNan(element(member(place, "at"), k));
    for (std::size_t k = 0; k < 3; ++k)
        claim.point[k] = numberOrNan(element(member(place, "point"), k));
    return claim;
}

/// \param options  of the fit
SurfacesPart readSurfaces(const Json& section, const Json& options) {
    SurfacesPart part;
    part.patches = all<SurfacesPart::Patch>(member(section, "patches"), readPatch);
    part.figures = readFigures(member(section, "deviation"));
    if (const Json& farthest = member(section, "farthest"); farthest.is_object())
        part.farthest = readClaim(farthest);
    if (const Json& creases = member(section, "creases"); creases.is_array())
        part.creases = readPaths(creases);
    part.folds = all<SurfacesPart::Claim>(member(section, "foldPlaces"), readClaim);
    part.isOfScan = member(section, "scan").is_object();
    part.interpolates = text(member(options, "fit")) == "interpolate";
    part.watertight = text(member(options, "fit")) == "smooth";
    return part;
}

} // namespace

CheckedDocument readDocument(const Json& root) {
    CheckedDocument document;
    const auto section = [&](const char* key) -> const Json* {
        const Json& value = member(root, key);
        return value.is_object() ? &value : nullptr;
    };
    if (const Json* value = section("constraints"))
        document.constraints = {readPaths(member(*value, "required")), readPaths(member(*value, "forbidden")),
                                all<ConstraintsPart::Weight>(member(*value, "weights"), readWeight)};
    if (const Json* value = section("baseComplex")) document.baseComplex = readBaseComplex(*value);
    if (const Json* value = section("features")) document.features = readFeatures(*value);
    if (const Json* value = section("cut")) document.cut = readCut(*value);
    if (const Json* value = section("enumeration")) {
        document.enumeration = readEnumeration(*value);
        document.weights = readWeights(*value);
    }
    if (const Json* value = section("layout")) {
        document.layout = readLayout(*value);
        document.layout->pruned = wasPruned(root);
        document.layout->tmesh = document.enumeration && document.enumeration->tmesh;
    }
    if (const Json* value = section("surfaces"))
        document.surfaces = readSurfaces(*value, optionsOf(root, "qm-bspline"));
    return document;
}

} // namespace qm::check
