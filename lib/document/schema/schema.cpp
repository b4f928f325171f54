#include "document/schema/schema.h"

#include "base/embedded_text.h"
#include "document/json/json.h"

#include <stdexcept>

namespace qm {

namespace {

/// The beginning of a reference to a definition in the same schema.
constexpr std::string_view localReference = "#/definitions/";

Json embedded(const std::string& file) {
    return Json::parse(textNamed(embeddedSchemas(), file));
}

/// Collects all definitions that a schema refers to, in any file, and makes the references local.
class Bundler {
public:
    explicit Bundler(const std::string& file) : file_(file), root_(embedded(file)) { files_[file] = root_; }

    /// Removes a key from the bundle.
    void forget(const char* key) { root_.erase(key); }

    /// Erasing a member invalidates what members know about their parent; the insertion at the end restores
    /// it.
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
            const std::size_t mark = reference.find(localReference);
            if (mark == std::string::npos) throw std::logic_error("unknown form of reference: " + reference);
            const std::string name = reference.substr(mark + localReference.size());
            include(mark == 0 ? file : reference.substr(0, mark), name);
            value = std::string(localReference) + name;
        }
    }

    void include(const std::string& file, const std::string& name) {
        if (definitions_.contains(name)) return;
        if (!files_.contains(file)) files_[file] = embedded(file);
        definitions_[name] = nullptr; // reserves the name, because a definition may refer to itself
        Json definition = files_.at(file).at("definitions").at(name);
        localise(definition, file);
        definitions_[name] = std::move(definition);
    }

    std::string file_;
    Json root_;
    Json files_ = Json::object();
    Json definitions_ = Json::object();
};

} // namespace

Json bundledSchema(const std::string& kind) {
    return Bundler(kind + ".schema.json").bundle();
}

Json namelessSchema(const std::string& kind) {
    Bundler bundler(kind + ".schema.json");
    bundler.forget("$id");
    return bundler.bundle();
}

std::string standaloneSchema(const std::string& kind) {
    return printJson(bundledSchema(kind));
}

const Json& referredTo(const Json& schema, const Json& part) {
    const Json* node = &part;
    while (node->is_object() && node->contains("$ref")) {
        const auto& reference = node->at("$ref").get_ref<const std::string&>();
        node = &schema.at("definitions").at(reference.substr(localReference.size()));
    }
    return *node;
}

} // namespace qm
