/// \file A true document with random edits is either refused with an Error or can be worked on, and the
/// checker copes with it in any case. The fuzzer's bytes choose the edits.
#include "base/error.h"
#include "check/check_document.h"
#include "check/document/read_document.h"
#include "check/mesh/neighbourhoods.h"
#include "document/document.h"
#include "document/model.h"
#include "document/sections/enumeration_section.h"
#include "document/sections/features_section.h"
#include "merge/merge.h"
#include "prune/prune_optimum.h"
#include "support/sample_document.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace {

using qm::Json;

/// Reads the fuzzer's bytes one after another, and zeros after their end.
class Choices {
public:
    Choices(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}
    [[nodiscard]] bool left() const { return next_ != end_; }
    std::size_t byte() { return left() ? *next_++ : 0; }
    /// \return a number below the count, or 0
    std::size_t below(std::size_t count) {
        const std::size_t number = count > 256 ? byte() << 8U | byte() : byte();
        return count == 0 ? 0 : number % count;
    }

private:
    const std::uint8_t* next_;
    const std::uint8_t* end_;
};

/// A random value inside a value.
Json& within(Json& value, Choices& choices) {
    if (value.empty() || !value.is_structured() || choices.below(8) == 7) return value;
    return within(*std::next(value.begin(), static_cast<std::ptrdiff_t>(choices.below(value.size()))),
                  choices);
}

/// A random section; kind, version and history are left out, because they have few meaningful values.
Json& place(Json& root, Choices& choices) {
    std::vector<std::string> sections{"mesh", "constraints"};
    for (const qm::Kind kind : qm::allKinds)
        sections.emplace_back(qm::sectionOf(kind));
    std::erase_if(sections, [&root](const std::string& section) { return !root.contains(section); });
    return within(root[sections[choices.below(sections.size())]], choices);
}

/// Adds constraints, as a person may before the search.
void demand(Json& root) {
    const Json& separatrices = root["baseComplex"]["separatrices"];
    const Json first = {{"vertices", separatrices[0]["vertices"]}};
    Json weight = {{"vertices", separatrices[1]["vertices"]}};
    weight["weight"] = 0.5;
    root["constraints"] = {{"required", Json::array({first})}, {"forbidden", Json::array()}};
    root["constraints"]["weights"] = Json::array({weight});
}

/// Copies a value without one key. Erasing the key would break the parent links of JSON for Modern C++'s
/// diagnostics.
Json without(const Json& value, std::size_t index) {
    Json rest = value.type();
    for (auto entry = value.begin(); entry != value.end(); ++entry) {
        if (index-- == 0) continue;
        if (value.is_object())
            rest[entry.key()] = *entry;
        else
            rest.push_back(*entry);
    }
    return rest;
}

Json number(Choices& choices) {
    switch (choices.below(6)) {
    case 1:
        return -1;
    case 2:
        return 1e300;
    case 3:
        return 0.5;
    case 4:
        return std::uint64_t{1} << choices.below(64);
    default:
        return choices.below(200);
    }
}

void editList(Json& list, Choices& choices) {
    const std::size_t one = choices.below(list.size()), other = choices.below(list.size());
    if (choices.below(2) == 0)
        list.push_back(Json(list[one]));
    else
        list[one].swap(list[other]);
}

void edit(Json& root, Choices& choices) {
    Json& value = place(root, choices);
    switch (choices.below(8)) {
    case 0:
    case 1:
        if (value.is_number()) value = number(choices);
        break;
    case 2:
    case 3:
    case 4:
        if (value.is_array() && !value.empty()) editList(value, choices);
        break;
    case 5:
        value = Json(place(root, choices));
        break;
    case 6:
        if (value.is_structured() && !value.empty()) value = without(value, choices.below(value.size()));
        break;
    default:
        value = choices.below(2) == 0 ? Json() : Json::array();
    }
}

/// Runs the next stages on a document.
void workOn(const qm::Document& document, const qm::Model& model) {
    qm::EnumerationOptions options;
    const qm::Enumeration enumeration =
        model.enumeration ? *model.enumeration : qm::enumerateGraphs(model.searched(), options);
    (void)qm::mergeGraphs(model.searched(), enumeration, 20, {});
    if (model.layout)
        (void)qm::prune({model.mesh, model.complex, model.dihedralAngles, model.edgeCosts}, *model.layout, {},
                        qm::sharpAngle(document.root));
}

/// A document, and qm-check's model of its mesh.
struct Sample {
    explicit Sample(qm::Kind kind) {
        // Measuring surfaces takes most of a run unless they are few and small.
        const bool small = kind == qm::Kind::surfaces;
        const qm::QuadMesh quads =
            qm::test::dividedCubes(small ? qm::test::box(2, 1, 1) : qm::test::bump(), small ? 1 : 3);
        root = qm::test::sampleDocument(folder, kind, quads).root;
        if (kind < qm::Kind::enumeration) demand(root);
        mesh = qm::check::checkedMesh(quads);
    }

    qm::test::TemporaryFolder folder;
    Json root;
    qm::check::CheckedMesh mesh;
};

const Sample& sample(std::size_t kind) {
    static const std::array<std::unique_ptr<const Sample>, qm::allKinds.size()> samples = [] {
        std::array<std::unique_ptr<const Sample>, qm::allKinds.size()> result;
        std::ranges::transform(qm::allKinds, result.begin(),
                               [](qm::Kind of) { return std::make_unique<Sample>(of); });
        return result;
    }();
    return *samples[kind];
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Choices choices(data, size);
    const Sample& start = sample(choices.below(qm::allKinds.size()));
    Json root = start.root;
    while (choices.left())
        edit(root, choices);
    (void)qm::check::checkDocument(start.mesh, qm::check::readDocument(root));
    try {
        qm::Document document = qm::parseDocument(qm::printJson(root), "document.json");
        const qm::Model model = qm::readWholeModel(document);
        workOn(document, model);
    } catch (const qm::Error&) {
        // Refused, as most edited documents should be.
    }
    return 0;
}
