#include "document/kind.h"

#include "base/at.h"

namespace qm {

namespace {

struct KindEntry {
    const char* name;
    const char* section;
    const char* tool;
};

constexpr std::array<KindEntry, allKinds.size()> entries{{{"basecomplex", "baseComplex", "qm-basecomplex"},
                                                          {"features", "features", "qm-features"},
                                                          {"cut", "cut", "qm-cut"},
                                                          {"enumeration", "enumeration", "qm-enum"},
                                                          {"layout", "layout", "qm-merge"},
                                                          {"surfaces", "surfaces", "qm-bspline"}}};

const KindEntry& entryOf(Kind kind) {
    return entries[at(kind)];
}

} // namespace

std::string kindName(Kind kind) {
    return entryOf(kind).name;
}
const char* sectionOf(Kind kind) {
    return entryOf(kind).section;
}
const char* toolOf(Kind kind) {
    return entryOf(kind).tool;
}

std::optional<Kind> kindOfName(std::string_view name) {
    for (const Kind kind : allKinds)
        if (name == entryOf(kind).name) return kind;
    return {};
}

std::optional<Kind> kindWrittenBy(std::string_view tool) {
    if (tool == "qm-prune") return Kind::layout;
    for (const Kind kind : allKinds)
        if (tool == entryOf(kind).tool) return kind;
    return {};
}

} // namespace qm
