#include "view/scene_json.h"

#include "base/at.h"
#include "view/number_bytes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace qm {
namespace {

using Json = nlohmann::ordered_json;

/// {"float32": base64}
Json array(const std::vector<float>& values) {
    return {{"float32", base64(floatBytes(values))}};
}

/// {"uint32" | "int32": base64 of differences}
Json array(const std::vector<std::uint32_t>& values) {
    return {{"uint32", base64(differenceBytes({values.begin(), values.end()}))}};
}
Json array(const std::vector<std::int32_t>& values) {
    return {{"int32", base64(differenceBytes({values.begin(), values.end()}))}};
}

/// Figures that one only looks at: {"uint16": base64, "unit": what 1 of them is}
Json roughArray(const std::vector<float>& values) {
    const RoughNumbers rough = roughNumbers(values);
    return {{"uint16", base64(rough.bytes)}, {"unit", rough.unit}};
}

/// Numbers of vertices and the like are whole.
Json columnValues(const std::vector<float>& values) {
    std::vector<std::int32_t> whole;
    for (const float value : values) {
        if (!(std::abs(value) < 1e7F) || value != std::floor(value)) return array(values);
        whole.push_back(static_cast<std::int32_t>(value));
    }
    return array(whole);
}

Json itemsJson(const Items& items) {
    Json columns = Json::array();
    for (const Column& column : items.columns)
        columns.push_back(
            {{"name", column.name},
             {"values", column.rough ? roughArray(column.values) : columnValues(column.values)}});
    Json json = {{"noun", items.noun}, {"count", items.count}, {"columns", std::move(columns)}};
    if (!items.pointer.empty()) json["pointer"] = items.pointer;
    return json;
}

Json layerJson(const Layer& layer) {
    return {{"name", layer.name},
            {"title", layer.title},
            {"base", static_cast<int>(layer.base)},
            {"items", itemsJson(layer.items)}};
}

Json mappedJson(const Mapped& mapped) {
    constexpr std::array scales{"none", "rising", "centred", "verdict"};
    Json json = {{"scale", scales[at(mapped.scale)]},
                 {"quantity", mapped.quantity},
                 {"unit", mapped.unit},
                 {"limit", mapped.limit.value_or(0)}};
    if (mapped.values.empty())
        json["source"] = mapped.source;
    else
        json["values"] = roughArray(mapped.values);
    return json;
}

Json json(const FaceLayer& layer) {
    constexpr std::array paints{"plain", "items", "mapped", "stripes"};
    Json result = layerJson(layer);
    result["paint"] = paints[at(layer.paint)];
    if (!layer.groups.empty()) result["groups"] = array(layer.groups);
    if (!layer.colours.empty()) result["colours"] = layer.colours;
    if (layer.mapped.scale != Scale::none) result["mapped"] = mappedJson(layer.mapped);
    if (!layer.itemsOf.empty()) result["itemsOf"] = layer.itemsOf;
    return result;
}

/// All items have as many points.
bool isRegular(const LineLayer& layer) {
    const std::size_t each = layer.points.size() / std::max<std::size_t>(layer.items.count, 1);
    for (std::size_t k = 0; k < layer.starts.size(); ++k)
        if (layer.starts[k] != k * each) return false;
    return true;
}

Json json(const LineLayer& layer) {
    Json result = layerJson(layer);
    if (layer.mapped.scale != Scale::none) result["mapped"] = mappedJson(layer.mapped);
    if (layer.starts.empty()) return result;
    if (!isRegular(layer)) result["starts"] = array(layer.starts);
    result["points"] = array(layer.points);
    return result;
}

Json json(const PointLayer& layer) {
    Json result = layerJson(layer);
    result["points"] = array(layer.points);
    return result;
}

Json json(const FittedPatches& patches) {
    return {{"degrees", patches.degrees},    {"counts", patches.counts},
            {"knots", patches.knots},        {"controlPoints", array(patches.controlPoints)},
            {"faces", array(patches.faces)}, {"steps", patches.steps}};
}

Json json(const Scene& scene);

template <class Values> Json list(const Values& values) {
    Json result = Json::array();
    for (const auto& value : values)
        result.push_back(json(value));
    return result;
}

Json json(const Scene& scene) {
    Json figures = Json::array();
    for (const auto& [name, value] : scene.figures)
        figures.push_back({name, value});
    return {{"title", scene.title},
            {"kind", scene.kind},
            {"figures", std::move(figures)},
            {"radius", scene.radius},
            {"mesh", {{"positions", array(scene.mesh.positions)}, {"quads", array(scene.mesh.quads)}}},
            {"patches", json(scene.patches)},
            {"subMeshOfVertex", array(scene.subMeshOfVertex)},
            {"faces", list(scene.faces)},
            {"lines", list(scene.lines)},
            {"points", list(scene.points)},
            {"shown", scene.shown}};
}

} // namespace

std::string sceneJson(std::span<const Scene> scenes, const PageOptions& options) {
    // The page's script knows no section by an axis of -1.
    const Json axis = options.section ? Json(options.section->axis) : Json(-1);
    const Json root = {{"scenes", list(scenes)},
                       {"shown", options.shown},
                       {"from", options.from},
                       {"up", options.up},
                       {"section", {{"axis", axis}, {"share", options.section.value_or(Section{}).share}}},
                       {"still", options.still},
                       {"key", options.key}};
    std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    // Of what could end a script's element, or change how it is read, all begins so.
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

} // namespace qm
