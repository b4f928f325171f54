#include "view/scene_json.h"

#include "view/base64.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <cstring>
#include <type_traits>

namespace qm {
namespace {

using Json = nlohmann::ordered_json;

/// {"float32" | "uint32" | "int32": base64 of little-endian numbers}
template <class Number> Json array(const std::vector<Number>& values) {
    static_assert(sizeof(Number) == 4);
    static_assert(std::endian::native == std::endian::little, "pages hold little-endian numbers");
    constexpr const char* type = std::is_floating_point_v<Number> ? "float32"
                                 : std::is_signed_v<Number>       ? "int32"
                                                                  : "uint32";
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                                 values.size() * sizeof(Number));
    return {{type, base64(bytes)}};
}

Json itemsJson(const Items& items) {
    Json columns = Json::array();
    for (const Column& column : items.columns)
        columns.push_back({{"name", column.name}, {"values", array(column.values)}});
    Json json = {{"noun", items.noun}, {"count", items.count}, {"columns", std::move(columns)}};
    if (!items.pointer.empty()) json["pointer"] = items.pointer;
    if (!items.pointers.empty()) json["pointers"] = items.pointers;
    return json;
}

/// What all layers have.
template <class Layer> Json layerJson(const Layer& layer) {
    return {{"name", layer.name},
            {"title", layer.title},
            {"base", static_cast<int>(layer.base)},
            {"items", itemsJson(layer.items)}};
}

Json json(const FaceLayer& layer) {
    Json result = layerJson(layer);
    if (!layer.groups.empty()) {
        result["groups"] = array(layer.groups);
        result["colours"] = layer.colours;
    }
    if (!layer.values.empty()) {
        result["values"] = array(layer.values);
        result["scale"] = layer.scale;
        result["unit"] = layer.unit;
    }
    return result;
}

Json json(const LineLayer& layer) {
    Json result = layerJson(layer);
    result["starts"] = array(layer.starts);
    result["points"] = array(layer.points);
    return result;
}

Json json(const PointLayer& layer) {
    Json result = layerJson(layer);
    result["points"] = array(layer.points);
    return result;
}

Json json(const Shell& shell) {
    return {{"positions", array(shell.positions)},
            {"normals", array(shell.normals)},
            {"quads", array(shell.quads)},
            {"faces", array(shell.faces)}};
}

template <class Values> Json list(const Values& values) {
    Json result = Json::array();
    for (const auto& value : values)
        result.push_back(json(value));
    return result;
}

} // namespace

std::string sceneJson(const Scene& scene, const PageOptions& options) {
    Json figures = Json::array();
    for (const auto& [name, value] : scene.figures)
        figures.push_back({name, value});
    const Json root = {{"title", scene.title},
                       {"kind", scene.kind},
                       {"figures", std::move(figures)},
                       {"radius", scene.radius},
                       {"from", options.from},
                       {"up", options.up},
                       {"still", options.still},
                       {"shells", list(scene.shells)},
                       {"subMeshOfVertex", array(scene.subMeshOfVertex)},
                       {"faces", list(scene.faces)},
                       {"lines", list(scene.lines)},
                       {"points", list(scene.points)},
                       {"shown", options.shown.empty() ? scene.shown : options.shown}};
    std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    // Of what could end a script's element, or change how it is read, all begins so.
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

} // namespace qm
