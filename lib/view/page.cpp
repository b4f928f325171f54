#include "view/page.h"

#include "base/error.h"
#include "view/page_parts.h"
#include "view/scene_json.h"

#include <algorithm>
#include <stdexcept>

namespace qm {
namespace {

std::string_view part(std::string_view name) {
    for (const PagePart& candidate : embeddedPageParts())
        if (candidate.name == name) return candidate.text;
    throw std::logic_error("the page lacks " + std::string(name));
}

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
        page += name == "scene" ? std::string_view(sceneJson) : part(name);
        if (!page.ends_with('\n')) page += '\n';
    }
    return page;
}

/// At most one of the layers may colour the faces: the others would hide behind it.
void requireLayers(const Scene& scene, const std::vector<std::string>& shown) {
    std::string known;
    std::string faces;
    const auto find = [&](const auto& layers, const std::string& name) {
        return std::any_of(layers.begin(), layers.end(),
                           [&](const auto& layer) { return layer.name == name; });
    };
    const auto list = [&known](const auto& layers) {
        for (const auto& layer : layers)
            known += (known.empty() ? "" : ", ") + layer.name;
    };
    for (const std::string& name : shown) {
        const bool colours = find(scene.faces, name);
        if (colours && !faces.empty())
            throw Error("", "layers " + faces + " and " + name + " both colour the faces",
                        "Show one of them");
        if (colours) faces = name;
        if (colours || find(scene.lines, name) || find(scene.points, name)) continue;
        list(scene.faces);
        list(scene.lines);
        list(scene.points);
        throw Error("", "there is no layer " + name, "This document has " + known);
    }
}

} // namespace

std::string printPage(const Scene& scene, const PageOptions& options) {
    requireLayers(scene, options.shown);
    return filledIn(part("page.html"), sceneJson(scene, options));
}

} // namespace qm
