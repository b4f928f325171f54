#include "document/schema.h"

#include "base/error.h"
#include "document/schema_view.h"

#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>

namespace qm {

namespace {

constexpr std::string_view localPrefix = "#/definitions/";

Json embedded(const std::string& file) {
    for (const EmbeddedSchema& schema : embeddedSchemas())
        if (schema.name == file) return Json::parse(schema.text);
    throw std::logic_error("there is no schema " + file);
}

/// Gathers all definitions that a schema refers to, in whichever file, and makes the references local.
class Bundler {
public:
    explicit Bundler(const std::string& file) : file_(file), root_(embedded(file)) { files_[file] = root_; }

    /// Leaves a key out of the bundle.
    void forget(const char* key) { root_.erase(key); }

    /// Ends with an insertion, which tells every member again what it is a member of: erasing forgets that.
    Json bundle() {
        forget("definitions");
        localise(root_, file_);
        root_["definitions"] = definitions_;
        return root_;
    }

private:
    void localise(Json& node, const std::string& file) {
        if (node.is_array())
            for (Json& element : node)
                localise(element, file);
        if (!node.is_object()) return;
        for (auto& [key, value] : node.items()) {
            if (key != "$ref" || !value.is_string()) {
                localise(value, file);
                continue;
            }
            const auto& reference = value.get_ref<const std::string&>();
            const std::size_t mark = reference.find(localPrefix);
            if (mark == std::string::npos) throw std::logic_error("unknown form of reference: " + reference);
            const std::string name = reference.substr(mark + localPrefix.size());
            include(mark == 0 ? file : reference.substr(0, mark), name);
            value = std::string(localPrefix) + name;
        }
    }

    void include(const std::string& file, const std::string& name) {
        if (definitions_.contains(name)) return;
        if (!files_.contains(file)) files_[file] = embedded(file);
        definitions_[name] = nullptr; // its place; a definition may refer to itself
        Json definition = files_.at(file).at("definitions").at(name);
        localise(definition, file);
        definitions_[name] = std::move(definition);
    }

    std::string file_;
    Json root_;
    Json files_ = Json::object();
    Json definitions_ = Json::object();
};

const Json& resolved(const Json& schema, const Json* node) {
    while (node->is_object() && node->contains("$ref")) {
        const auto& reference = node->at("$ref").get_ref<const std::string&>();
        node = &schema.at("definitions").at(reference.substr(localPrefix.size()));
    }
    return *node;
}

/// A place in a document, with what the schema says about it.
struct Place {
    JsonPointer pointer;
    const Json* value = nullptr;
    Json rule; ///< the sub-schema, with the description of whoever refers to it
};

/// Follows Valijson's context, "[key]" or "[position among the shown elements]" per step.
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
        rule = &resolved(schema, next);
        place.rule = *rule;
        if (next->contains("description")) place.rule["description"] = next->at("description");
    }
    return place;
}

std::string listOf(const Json& names) {
    if (!names.is_array()) return names.is_string() ? names.get<std::string>() : names.dump();
    std::string text;
    for (const Json& name : names)
        text += (text.empty() ? "" : " or ") + listOf(name);
    return text;
}

std::string withSmallStart(std::string text) {
    if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    while (text.ends_with('.'))
        text.pop_back();
    return text;
}

/// What is wrong, in the words of this schema where that is simple, else in Valijson's.
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

Json bundledSchema(const std::string& kind) {
    return Bundler(kind + ".schema.json").bundle();
}

std::string standaloneSchema(const std::string& kind) {
    return printJson(bundledSchema(kind));
}

void validate(const Json& root, const Json& schema) {
    valijson::Schema compiled;
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(schema_view::Adapter(schema), compiled);

    valijson::ValidationResults results;
    valijson::Validator validator;
    if (validator.validate(compiled, schema_view::Adapter({&root, &results}), &results)) return;
    valijson::ValidationResults::Error first;
    results.popError(first);
    const Place place = follow(root, schema, first.context);
    const std::string meaning = place.pointer.empty() ? "" : place.rule.value("description", "");
    throw Error(place.pointer.to_string(), problemAt(place, first.description),
                meaning.empty() ? "" : "It means: " + withSmallStart(meaning));
}

void validateAgainstSchema(const Json& root, const std::string& kind) {
    Bundler bundler(kind + ".schema.json");
    bundler.forget("$id"); // nothing is to be fetched
    validate(root, bundler.bundle());
}

} // namespace qm
