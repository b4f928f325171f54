#include "document/schema/schema_check.h"

#include "base/error.h"
#include "base/joined.h"
#include "document/schema/schema.h"
#include "document/schema/schema_violation.h"
#include "document/schema/shown_elements.h"

#include <cctype>

namespace qm {

namespace {

/// A place in a document, and the sub-schema for it.
struct Place {
    JsonPointer pointer;
    const Json* value = nullptr;
    Json rule; ///< with the description of the schema that refers to it
};

/// Follows the context of Valijson's error: "[key]" or "[position among the shown elements]" for every step.
Place follow(const Json& root, const Json& schema, const std::vector<std::string>& context) {
    Place place{JsonPointer(), &root, schema};
    const Json* rule = &schema;
    for (std::size_t step = 1; step < context.size(); ++step) {
        const std::string name = context[step].substr(1, context[step].size() - 2);
        const Json* next = nullptr;
        if (place.value->is_array()) {
            const auto& array = place.value->get_ref<const Json::array_t&>();
            const std::size_t position = shownElements(array).at(std::stoul(name));
            place.pointer /= position;
            place.value = &array[position];
            if (rule->contains("items")) next = &rule->at("items");
        } else {
            place.pointer /= name;
            place.value = &place.value->at(name);
            if (rule->contains("properties") && rule->at("properties").contains(name))
                next = &rule->at("properties").at(name);
        }
        static const Json anything = Json::object();
        if (next == nullptr) next = &anything;
        rule = &referredTo(schema, *next);
        place.rule = *rule;
        if (next->contains("description")) place.rule["description"] = next->at("description");
    }
    return place;
}

std::string listOf(const Json& names) {
    if (!names.is_array()) return names.is_string() ? names.get<std::string>() : names.dump();
    return joined(names, " or ", listOf);
}

std::string withSmallStart(std::string text) {
    if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    while (text.ends_with('.'))
        text.pop_back();
    return text;
}

/// What is wrong: in our own words for simple rules, otherwise in Valijson's.
std::string problemAt(const Place& place, const std::string& description) {
    const auto ruleSays = [&](const char* keyword, const char* mention) {
        return place.rule.contains(keyword) && description.find(mention) != std::string::npos;
    };
    if (ruleSays("type", "'type'"))
        return std::string("is ") + place.value->type_name() + ", not " + listOf(place.rule.at("type"));
    if (ruleSays("const", "const")) return "is not " + listOf(place.rule.at("const"));
    if (ruleSays("enum", "enum")) return "is not " + listOf(place.rule.at("enum"));
    if (ruleSays("pattern", "attern")) return "is not of the form " + listOf(place.rule.at("pattern"));
    if (ruleSays("minimum", "number greater")) return "is less than " + listOf(place.rule.at("minimum"));
    if (ruleSays("maximum", "number less")) return "is more than " + listOf(place.rule.at("maximum"));
    if (description.starts_with("Missing required property '"))
        return "lacks " + description.substr(std::string("Missing required property ").size(),
                                             description.rfind('\'') - description.find('\'') + 1);
    return withSmallStart(description);
}

} // namespace

void validate(const Json& root, const Json& schema) {
    const std::optional<SchemaViolation> first = firstViolation(root, schema);
    if (!first) return;
    const Place place = follow(root, schema, first->context);
    const std::string meaning = place.pointer.empty() ? "" : place.rule.value("description", "");
    throw Error(place.pointer.to_string(), problemAt(place, first->description),
                meaning.empty() ? "" : "It means: " + withSmallStart(meaning));
}

void validateAgainstSchema(const Json& root, const std::string& kind) {
    validate(root, namelessSchema(kind));
}

} // namespace qm
