#include "view/layers.h"

namespace qm {

void appendPosition(std::vector<float>& positions, const Point& point, const Point& centre) {
    for (unsigned k = 0; k < 3; ++k)
        positions.push_back(static_cast<float>(point[k] - centre[k]));
}

void addFigure(Items& items, const std::string& name, double value) {
    for (Column& column : items.columns)
        if (column.name == name) {
            column.values.push_back(static_cast<float>(value));
            return;
        }
    items.columns.push_back({name, {static_cast<float>(value)}});
}

LineLayer newLines(const std::string& name, const std::string& title, const std::string& noun,
                   const std::string& pointer) {
    auto layer = newLayer<LineLayer>(name, title, noun, pointer);
    layer.starts = {0};
    return layer;
}

void endItem(LineLayer& layer) {
    layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    ++layer.items.count;
}

void addItem(LineLayer& layer, std::span<const VertexId> vertices) {
    for (const VertexId vertex : vertices)
        layer.points.push_back(static_cast<std::uint32_t>(vertex.idx()));
    endItem(layer);
}

void addPath(LineLayer& layer, const std::vector<VertexId>& vertices) {
    addFigure(layer.items, "from vertex", vertices.front().idx());
    addFigure(layer.items, "to vertex", vertices.back().idx());
    addFigure(layer.items, "edges", static_cast<double>(vertices.size()) - 1);
    addItem(layer, vertices);
}

void addPoint(PointLayer& layer, VertexId vertex) {
    layer.points.push_back(static_cast<std::uint32_t>(vertex.idx()));
    ++layer.items.count;
}

} // namespace qm
