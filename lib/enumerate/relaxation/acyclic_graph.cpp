#include "enumerate/relaxation/acyclic_graph.h"

#include <utility>

namespace qm {

bool AcyclicGraph::add(std::size_t from, std::size_t to) {
    if (reaches(to, from)) return false;
    next_[from].push_back(to);
    return true;
}

bool AcyclicGraph::reaches(std::size_t first, std::size_t wanted) {
    ++search_;
    seen_[first] = search_;
    for (std::vector<std::size_t> reached{first}; !reached.empty();) {
        const std::size_t node = reached.back();
        reached.pop_back();
        if (node == wanted) return true;
        for (const std::size_t next : next_[node])
            if (std::exchange(seen_[next], search_) != search_) reached.push_back(next);
    }
    return false;
}

} // namespace qm
