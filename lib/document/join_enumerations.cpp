#include "document/join_enumerations.h"

#include "base/decimal.h"
#include "document/files/files.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

constexpr const char* remedy = "Give all parts of one search, each once";

Json& sectionOfPart(Document& document) {
    return document.root[sectionOf(Kind::enumeration)];
}

/// What a part's own search found, taken out of its document.
struct Found { // NOLINT(bugprone-exception-escape): Json's constructors throw, but not these
    std::string path;
    std::int64_t number = 0;
    Json count;
    bool complete = false;
    Json::array_t subMeshes;
};

class Joiner {
public:
    explicit Joiner(std::vector<Document> parts) : parts_(std::move(parts)) {}

    Document join() {
        for (Document& part : parts_)
            found_.push_back(inFile(displayName(part.path), [&] { return takeOut(part); }));
        std::ranges::sort(found_, {}, &Found::number);
        verifyNumbers();
        for (const Document& part : parts_)
            if (part.root != parts_.front().root)
                throw FileError(displayName(part.path),
                                "is a part of another document, or of a search with other options, than " +
                                    displayName(parts_.front().path),
                                remedy);
        Json& section = sectionOfPart(parts_.front());
        section["complete"] = std::ranges::all_of(found_, &Found::complete);
        section["count"] = product();
        section["subMeshes"] = subMeshes();
        return std::move(parts_.front());
    }

private:
    /// Takes the findings of a part out of its document; the rest of the document is the same for all parts.
    Found takeOut(Document& document) {
        const JsonPlace place = document.section(Kind::enumeration);
        const auto part = place.find("part");
        if (!part) place.fail("is no part of a search", remedy);
        Found found;
        found.path = displayName(document.path);
        const std::int64_t of = (*part)["of"].whole(2);
        if (of_ != 0 && of != of_)
            (*part)["of"].fail("is not " + std::to_string(of_) + ", as before", remedy);
        of_ = of;
        found.number = (*part)["number"].whole(1, of_);
        Json& section = sectionOfPart(document);
        found.count = std::exchange(section["count"], Json());
        found.complete = std::exchange(section["complete"], Json(false)).get<bool>();
        found.subMeshes = std::exchange(section["subMeshes"], Json::array()).get_ref<Json::array_t&>();
        section.erase("part");
        return found;
    }

    void verifyNumbers() const {
        for (std::size_t k = 0; k < found_.size(); ++k)
            if (std::cmp_not_equal(found_[k].number, k + 1)) {
                const bool twice = k > 0 && found_[k].number == found_[k - 1].number;
                throw FileError(found_[k].path,
                                twice ? "is part " + std::to_string(found_[k].number) + " once more"
                                      : "part " + std::to_string(k + 1) + " is missing",
                                remedy);
            }
        if (std::cmp_not_equal(found_.size(), of_))
            throw FileError(found_.back().path, "part " + std::to_string(found_.size() + 1) + " is missing",
                            remedy);
    }

    [[nodiscard]] Json product() const {
        std::vector<std::string> counts;
        for (const Found& part : found_) {
            if (part.count.is_null()) return {};
            counts.push_back(part.count.get<std::string>());
        }
        return decimalProduct(counts);
    }

    /// Merges the sub-meshes, which were dealt out to the parts in turn.
    Json::array_t subMeshes() {
        std::size_t total = 0;
        for (const Found& part : found_)
            total += part.subMeshes.size();
        Json::array_t result;
        for (std::size_t id = 0; id < total; ++id) {
            Found& part = found_[id % found_.size()];
            const std::size_t place = id / found_.size();
            if (place >= part.subMeshes.size() || part.subMeshes[place].value("id", Json()) != id)
                throw FileError(part.path, "does not hold sub-mesh " + std::to_string(id), remedy);
            result.push_back(std::move(part.subMeshes[place]));
        }
        return result;
    }

    std::vector<Document> parts_;
    std::vector<Found> found_;
    std::int64_t of_ = 0; ///< number of parts
};

} // namespace

Document joinEnumerations(std::vector<Document> parts) {
    return Joiner(std::move(parts)).join();
}

} // namespace qm
