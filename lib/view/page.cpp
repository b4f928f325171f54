#include "view/page.h"

#include "base/embedded_text.h"
#include "base/error.h"
#include "base/joined.h"
#include "view/scene_json.h"

#include <algorithm>

namespace qm {
namespace {

/// Every line that is "{{name}}" and nothing else becomes the part of that name.
std::string filledIn(std::string_view frame, const std::string& sceneJson) {
    std::string page;
    while (!frame.empty()) {
        const std::size_t end = std::min(frame.find('\n'), frame.size() - 1) + 1;
        std::string_view line = frame.substr(0, end);
        frame.remove_prefix(end);
        if (!line.starts_with("{{")) {
            page += line;
            continue;
        }
        const std::string_view name = line.substr(2, line.find("}}") - 2);
        page += name == "scene" ? std::string_view(sceneJson) : textNamed(embeddedPageParts(), name);
        if (!page.ends_with('\n')) page += '\n';
    }
    return page;
}

template <class Layers> bool has(const Layers& layers, const std::string& name) {
    return std::ranges::find(layers, name, &Layer::name) != layers.end();
}

/// The names of all layers, each once.
std::string namesOf(std::span<const Scene> scenes) {
    std::vector<std::string> names;
    const auto list = [&names](const auto& layers) {
        for (const auto& layer : layers)
            if (std::ranges::find(names, layer.name) == names.end()) names.push_back(layer.name);
    };
    for (const Scene& scene : scenes) {
        list(scene.faces);
        list(scene.lines);
        list(scene.points);
    }
    return joined(names);
}

/// At most one of the layers may colour the faces: the others would hide behind it.
void requireLayers(std::span<const Scene> scenes, const std::vector<std::string>& shown) {
    std::string faces;
    for (const std::string& name : shown) {
        const bool colours =
            std::ranges::any_of(scenes, [&](const Scene& scene) { return has(scene.faces, name); });
        const bool draws = std::ranges::any_of(
            scenes, [&](const Scene& scene) { return has(scene.lines, name) || has(scene.points, name); });
        if (colours && !faces.empty())
            throw Error("",
                        std::string("layers ").append(faces).append(" and ").append(name).append(
                            " both colour the faces"),
                        "Show one of them");
        if (colours) faces = name;
        if (!colours && !draws)
            throw Error("", "there is no layer " + name, "What is shown has " + namesOf(scenes));
    }
}

} // namespace

std::string printPage(std::span<const Scene> scenes, const PageOptions& options) {
    requireLayers(scenes, options.shown);
    return filledIn(textNamed(embeddedPageParts(), "page.html"), sceneJson(scenes, options));
}

} // namespace qm
