#include "document/schema/misspelt_keys.h"

#include "document/json/json.h"
#include "document/schema/schema.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string_view>

namespace qm {
namespace {

/// The number of letters to insert, delete or replace to turn one word into the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
        }
    }
    return row.back();
}

class Search {
public:
    explicit Search(const std::string& kind) : schema_(bundledSchema(kind)) {}

    std::vector<std::string> run(const Json& root) {
        walk(root, schema_, JsonPointer());
        return std::move(found_);
    }

private:
    /// Whether values of this rule may contain objects; long lists of numbers need not be visited.
    [[nodiscard]] bool hasKeys(const Json& rule) const {
        const Json& here = referredTo(schema_, rule);
        return here.contains("properties") || (here.contains("items") && hasKeys(here.at("items")));
    }

    void walk(const Json& value, const Json& rule, const JsonPointer& pointer) {
        const Json& here = referredTo(schema_, rule);
        if (value.is_array() && here.contains("items") && hasKeys(here.at("items")))
            for (std::size_t k = 0; k < value.size(); ++k)
                walk(value[k], here.at("items"), pointer / k);
        if (!value.is_object() || !here.contains("properties")) return;
        const Json& known = here.at("properties");
        // Found once, because finding a key takes linear time.
        std::optional<std::vector<std::string>> missing;
        for (const auto& [key, member] : value.items())
            if (known.contains(key)) {
                walk(member, known.at(key), pointer / key);
            } else {
                if (!missing) missing = missingNames(value, known);
                compare(key, *missing, pointer);
            }
    }

    [[nodiscard]] static std::vector<std::string> missingNames(const Json& value, const Json& known) {
        std::vector<std::string> names;
        for (const auto& [name, rule] : known.items())
            if (!value.contains(name)) names.push_back(name);
        return names;
    }

    void compare(const std::string& key, const std::vector<std::string>& missing,
                 const JsonPointer& pointer) {
        constexpr std::size_t near = 2;
        if (key.empty()) return;
        std::size_t nearest = std::min(near, (key.size() - 1) / 2) + 1; // fewer letters for short keys
        std::string meant;
        for (const std::string& name : missing) {
            const std::size_t distance = editDistance(key, name);
            if (distance >= nearest) continue;
            nearest = distance;
            meant = name;
        }
        if (!meant.empty())
            found_.push_back((pointer / key).to_string() + ": no tool reads this key. Is it '" + meant +
                             "'?");
    }

    Json schema_;
    std::vector<std::string> found_;
};

} // namespace

std::vector<std::string> misspeltKeys(const Json& root, const std::string& kind) {
    return Search(kind).run(root);
}

} // namespace qm
