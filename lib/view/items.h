/// \file Fills layers item by item.
#pragma once

#include "mesh/quad_mesh.h"
#include "view/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace qm {

/// Adds a figure of the next item to the column of that name, which is made when it is first used.
inline void addFigure(Items& items, const std::string& name, double value) {
    for (Column& column : items.columns)
        if (column.name == name) {
            column.values.push_back(static_cast<float>(value));
            return;
        }
    items.columns.push_back({name, {static_cast<float>(value)}});
}

/// An empty layer, with the place where its first item begins.
inline LineLayer newLines(const std::string& name, const std::string& title, const std::string& noun,
                          const std::string& pointer) {
    LineLayer layer;
    layer.name = name;
    layer.title = title;
    layer.starts = {0};
    layer.items.noun = noun;
    layer.items.pointer = pointer;
    return layer;
}

/// Ends the item whose points were added.
inline void endItem(LineLayer& layer) {
    layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    ++layer.items.count;
}

/// Adds a whole item.
inline void addItem(LineLayer& layer, const std::vector<VertexId>& vertices) {
    for (const VertexId vertex : vertices)
        layer.points.push_back(static_cast<std::uint32_t>(vertex.idx()));
    endItem(layer);
}

/// Adds a whole item, and between which vertices it runs.
inline void addPath(LineLayer& layer, const std::vector<VertexId>& vertices) {
    addFigure(layer.items, "from vertex", vertices.front().idx());
    addFigure(layer.items, "to vertex", vertices.back().idx());
    addFigure(layer.items, "edges", static_cast<double>(vertices.size()) - 1);
    addItem(layer, vertices);
}

inline void addPoint(PointLayer& layer, VertexId vertex) {
    layer.points.push_back(static_cast<std::uint32_t>(vertex.idx()));
    ++layer.items.count;
}

} // namespace qm
