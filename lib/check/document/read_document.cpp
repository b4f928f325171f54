#include "check/document/read_document.h"

#include "check/document/check_history.h"
#include "check/document/json_values.h"

namespace qm::check {

namespace {

std::vector<std::vector<int>> readPaths(const JsonValue& list) {
    return list.all([](const JsonValue& path) { return path["vertices"].wholes(); });
}

BaseComplexPart readBaseComplex(const JsonValue& section) {
    const auto readSeparatrix = [](const JsonValue& separatrix) {
        return BaseComplexPart::Separatrix{separatrix["id"].whole(), separatrix["vertices"].wholes(),
                                           separatrix["opposite"].wholeIfAny(),
                                           separatrix["selfCrossing"].isTrue()};
    };
    return {section["extraordinaryVertices"].wholes(), section["ordinaryJunctions"].whole(),
            section["separatrices"].all(readSeparatrix)};
}

FeaturesPart readFeatures(const JsonValue& section) {
    return {section["curves"].all([](const JsonValue& curve) {
        return FeaturesPart::Curve{curve["id"].whole(), curve["vertices"].wholes(), curve["seed"].whole()};
    })};
}

CutPart readCut(const JsonValue& section) {
    const auto readSubMesh = [](const JsonValue& subMesh) {
        return CutPart::SubMesh{subMesh["id"].whole(), subMesh["quasiComplexity"].number(),
                                subMesh["ordinaryJunctions"].wholeIfAny(), subMesh["source"].wholeIfAny(),
                                subMesh["sink"].wholeIfAny()};
    };
    return {section["labels"].wholes(), section["subMeshes"].all(readSubMesh)};
}

TrackPart readTrack(const JsonValue& track) {
    return {track["id"].wholeIfAny(),   track["separatrix"].wholeIfAny(), track["source"].wholeIfAny(),
            track["vertices"].wholes(), track["cost"].number(),           track["transversal"].isTrue()};
}

EnumerationPart readEnumeration(const JsonValue& section) {
    const auto readGraph = [](const JsonValue& graph) {
        return EnumerationPart::Graph{graph["cost"].number(), graph["tracks"].all(readTrack)};
    };
    const auto readSubMesh = [&](const JsonValue& subMesh) {
        return EnumerationPart::SubMesh{
            subMesh["id"].whole(),   subMesh["cost"].number(),         subMesh["lowerBound"].number(),
            subMesh["count"].text(), subMesh["graphs"].all(readGraph), subMesh["samples"].all(readGraph)};
    };
    return {section["class"].text() == "tmesh", section["count"].text(),
            section["subMeshes"].all(readSubMesh)};
}

CostWeights readWeights(const JsonValue& section) {
    CostWeights weights{section["alpha"].numberOrNan(), section["epsilon"].numberOrNan()};
    const auto read = [terms = section["terms"]](const char* name, double& weight) {
        if (!terms[name].isNull()) weight = terms[name].numberOrNan();
    };
    read("dihedral", weights.dihedral);
    read("length", weights.length);
    read("segments", weights.segments);
    read("custom", weights.custom);
    return weights;
}

ConstraintsPart readConstraints(const JsonValue& section) {
    const auto readWeight = [](const JsonValue& entry) {
        return ConstraintsPart::Weight{entry["vertices"].wholes(), entry["weight"].numberOrNan()};
    };
    return {readPaths(section["required"]), readPaths(section["forbidden"]),
            section["weights"].all(readWeight)};
}

LayoutPart::Segment readSegment(const JsonValue& segment) {
    return {segment["id"].whole(), segment["size"].first<2>(&JsonValue::whole),
            segment["corners"].first<4>(&JsonValue::whole), segment["sides"].first<4>(&JsonValue::wholes),
            segment["faces"].wholes()};
}

LayoutPart::FrontPoint readFrontPoint(const JsonValue& point) {
    return {point["beta"].numberOrNan(),      point["segments"].numberOrNan(),
            point["cost"].numberOrNan(),      point["capturedSharpness"].numberOrNan(),
            point["objectiveBound"].number(), point["proven"].isTrue()};
}

LayoutPart readLayout(const JsonValue& section) {
    LayoutPart part;
    part.cost = section["cost"].number();
    part.lowerBound = section["lowerBound"].number();
    part.tracks = section["tracks"].all(readTrack);
    part.divided = section["segments"].isArray();
    part.segments = section["segments"].all(readSegment);
    const JsonValue quality = section["quality"];
    part.quality = {quality["rho"].number(),          quality["segments"].number(),
                    quality["tJoints"].number(),      quality["capturedSharpness"].number(),
                    quality["medianAspect"].number(), quality["maxAspect"].number(),
                    quality["gap"].number()};
    part.front = section["prune"]["front"].all(readFrontPoint);
    return part;
}

SurfacesPart::Patch readPatch(const JsonValue& patch) {
    SurfacesPart::Patch part;
    part.segment = patch["segment"].whole();
    part.degree = patch["degree"].first<2>(&JsonValue::whole);
    part.knots =
        patch["knots"].first<2>([](const JsonValue& knots) { return knots.all(&JsonValue::numberOrNan); });
    const JsonValue rows = patch["controlPoints"];
    const std::size_t width = rows[0].size();
    part.count = {static_cast<int>(width), static_cast<int>(rows.size())};
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const JsonValue row = rows[j];
        part.rectangular = part.rectangular && row.size() == width;
        for (std::size_t i = 0; i < row.size(); ++i)
            part.controlPoints.push_back(row[i].first<3>(&JsonValue::numberOrNan));
    }
    part.figures = {patch["deviation"].numbers()};
    return part;
}

/// The options of the last tool of this name in the history; null if it took no part.
JsonValue optionsOf(const JsonValue& root, const char* tool) {
    const JsonValue history = root["history"];
    for (std::size_t k = history.size(); k-- > 0;)
        if (history[k]["tool"].text() == tool) return history[k]["options"];
    return JsonValue::none();
}

SurfacesPart::Claim readClaim(const JsonValue& place) {
    return {place["patch"].whole(), place["at"].first<2>(&JsonValue::numberOrNan),
            place["point"].first<3>(&JsonValue::numberOrNan)};
}

/// \param options  of the fit
SurfacesPart readSurfaces(const JsonValue& section, const JsonValue& options) {
    SurfacesPart part;
    part.patches = section["patches"].all(readPatch);
    part.figures = {section["deviation"].numbers()};
    if (section["farthest"].isObject()) part.farthest = readClaim(section["farthest"]);
    if (section["creases"].isArray()) part.creases = readPaths(section["creases"]);
    part.folds = section["foldPlaces"].all(readClaim);
    part.isOfScan = section["scan"].isObject();
    part.interpolates = options["fit"].text() == "interpolate";
    part.watertight = options["fit"].text() == "smooth";
    return part;
}

} // namespace

CheckedDocument readDocument(const Json& document) {
    const JsonValue root(document);
    const auto readIfAny = [&](const char* key, const auto& read) {
        const JsonValue section = root[key];
        return section.isObject() ? std::optional(read(section)) : std::nullopt;
    };
    CheckedDocument result;
    result.constraints = readIfAny("constraints", readConstraints);
    result.baseComplex = readIfAny("baseComplex", readBaseComplex);
    result.features = readIfAny("features", readFeatures);
    result.cut = readIfAny("cut", readCut);
    result.enumeration = readIfAny("enumeration", readEnumeration);
    result.weights = readIfAny("enumeration", readWeights);
    result.layout = readIfAny("layout", readLayout);
    if (result.layout) {
        result.layout->pruned = wasPruned(document);
        result.layout->tmesh = result.enumeration && result.enumeration->tmesh;
    }
    result.surfaces = readIfAny("surfaces", [&](const JsonValue& section) {
        return readSurfaces(section, optionsOf(root, "qm-bspline"));
    });
    return result;
}

} // namespace qm::check
