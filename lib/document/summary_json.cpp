#include "document/summary_json.h"

#include "document/options/options_json.h"
#include "document/sections/surfaces_section.h"

namespace qm {
namespace {

Json fitToJson(const FitSummary& fit) {
    const Deviation& deviation = fit.deviation;
    Json json{{"fit", choiceName(fit.smooth ? Fit::smooth : Fit::interpolate)}};
    json["tolerance"] = fit.smooth ? Json(fit.tolerance) : Json();
    json["deviation"] = deviation.max;
    json["deviationRelative"] = deviation.maxRelative;
    json["maxFromFacets"] = deviation.maxFromFacets;
    json["farthest"] = placeToJson(fit.farthest.place, fit.farthest.point);
    json["scan"] = Json();
    if (fit.scan) {
        json["scan"] = figuresToJson(*fit.scan);
        json["scan"]["farthest"] = placeToJson(fit.farthestFromScan.place, fit.farthestFromScan.point);
    }
    json["gap"] = deviation.largestGap;
    json["largestNormalAngle"] = deviation.largestNormalAngle;
    json["percentile95NormalAngle"] = deviation.percentile95NormalAngle;
    json["folds"] = deviation.folds;
    json["fold"] = fit.fold ? placeToJson(fit.fold->place, fit.fold->point) : Json();
    json["bridged"] = Json();
    if (fit.bridged) json["bridged"] = {{"distance", fit.bridged->distance}, {"patch", fit.bridged->patch}};
    return json;
}

} // namespace

FitOptions recordedFit(const JsonPlace& history) {
    FitOptions fit;
    for (const JsonPlace& step : history.elements()) {
        if (step["tool"].value() != "qm-bspline") continue;
        const JsonPlace options = step["options"];
        if (const auto name = options.find("fit")) readChoice(*name, fit.fit);
        if (const auto rho = options.find("rho")) fit.rho = rho->number();
        const auto tolerance = options.find("tolerance");
        if (!tolerance) continue;
        const bool isNumber = tolerance->value().is_number();
        if (isNumber) fit.tolerance = {tolerance->number(), false};
        if ((!isNumber && !parseLength(tolerance->text(), fit.tolerance)) || fit.tolerance.value <= 0)
            tolerance->fail("is no tolerance");
    }
    return fit;
}

Json summaryToJson(const Summary& summary, const std::string& name, const std::string& unit,
                   std::optional<double> seconds, const std::vector<std::string>& unmet) {
    Json json{{"mesh", name}, {"unit", unit}, {"quads", summary.quads}, {"vertices", summary.vertices}};
    json["pieces"] = summary.pieces;
    json["cavities"] = summary.cavities;
    json["size"] = summary.size;
    json["diagonal"] = summary.diagonal;
    json["boundaryLoops"] = Json::array();
    for (const BoundaryLoop& loop : summary.loops)
        json["boundaryLoops"].push_back(
            {{"vertex", loop.vertex.idx()}, {"edges", loop.edges}, {"length", loop.length}});
    json["patches"] = valueOrNull(summary.patches);
    json["surfaces"] = summary.fit ? fitToJson(*summary.fit) : Json();
    json["solid"] = isSolid(summary);
    json["seconds"] = valueOrNull(seconds);
    json["unmet"] = unmet;
    return json;
}

} // namespace qm
