#include "enumerate/diagram/walk.h"

namespace qm {

std::vector<DiagramPart> splitDiagram(const Diagram& diagram, std::size_t minParts) {
    std::vector<DiagramPart> parts;
    if (diagram.root != Diagram::none) parts.push_back({diagram.root, diagram.fixed});
    for (bool split = true; split && parts.size() < minParts;) {
        split = false;
        std::vector<DiagramPart> finer;
        for (DiagramPart& part : parts) {
            if (part.node == Diagram::end) {
                finer.push_back(std::move(part));
                continue;
            }
            split = true;
            const Diagram::Node& node = diagram.nodes[part.node];
            for (const auto& [next, value] : {std::pair(node.in, 1), std::pair(node.out, 0)}) {
                if (next == Diagram::none) continue;
                finer.push_back({next, part.before});
                if (node.variable.valid())
                    finer.back().before[node.variable] = static_cast<signed char>(value);
            }
        }
        parts = std::move(finer);
    }
    return parts;
}

} // namespace qm
