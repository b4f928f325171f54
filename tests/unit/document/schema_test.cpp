/// \file The schemas are valid, and documents of every kind conform to them.
#include "base/embedded_text.h"
#include "base/error.h"
#include "document/json/json_place.h"
#include "document/schema/schema.h"
#include "document/schema/schema_check.h"
#include "document/schema/shown_elements.h"
#include "support/message_of.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

namespace {

using qm::Json;
using qm::Kind;
using qm::parseJson;
using qm::test::messageOf;
using qm::test::sampleDocument;

/// The part of draft-07 that our schemas use, and nothing else: validation visits only three numbers of a
/// long list, which is correct for these keywords but not for all.
const char* const metaSchema = R"({
  "definitions": {
    "schema": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "$schema": {"const": "http://json-schema.org/draft-07/schema#"},
        "$id": {"type": "string"}, "$ref": {"type": "string", "pattern": "#/definitions/[A-Za-z0-9]+$"},
        "title": {"type": "string"}, "description": {"type": "string"},
        "type": {"anyOf": [{"$ref": "#/definitions/typeName"},
                           {"type": "array", "items": {"$ref": "#/definitions/typeName"}}]},
        "const": {}, "enum": {"type": "array", "minItems": 1},
        "minimum": {"type": "number"}, "maximum": {"type": "number"},
        "minLength": {"type": "integer", "minimum": 0}, "pattern": {"type": "string"},
        "minItems": {"type": "integer", "minimum": 0}, "maxItems": {"type": "integer", "minimum": 0},
        "items": {"$ref": "#/definitions/schema"},
        "required": {"type": "array", "items": {"type": "string"}},
        "properties": {"type": "object", "additionalProperties": {"$ref": "#/definitions/schema"}},
        "definitions": {"type": "object", "additionalProperties": {"$ref": "#/definitions/schema"}}
      }
    },
    "typeName": {"enum": ["array", "boolean", "integer", "null", "number", "object", "string"]}
  },
  "$ref": "#/definitions/schema"
})";

TEST(Schemas, AreValidAndUseOnlyWhatTheValidatorTreatsRight) {
    const Json meta = parseJson(metaSchema);
    EXPECT_EQ(qm::embeddedSchemas().size(), qm::allKinds.size() + 1);
    for (const qm::EmbeddedText& schema : qm::embeddedSchemas())
        EXPECT_NO_THROW(qm::validate(parseJson(schema.text), meta)) << schema.name;
    EXPECT_THROW(qm::validate(parseJson(R"({"type": "text"})"), meta), qm::Error);
    EXPECT_THROW(qm::validate(parseJson(R"({"properties": {"a": {"uniqueItems": true}}})"), meta), qm::Error);
}

TEST(Schemas, DefinitionsHaveDifferentNames) {
    std::set<std::string> names;
    for (const qm::EmbeddedText& schema : qm::embeddedSchemas()) {
        const Json root = parseJson(schema.text);
        EXPECT_EQ(root.at("$id"), schema.name);
        for (const auto& [name, definition] : root.at("definitions").items())
            EXPECT_TRUE(names.insert(name).second) << name;
    }
}

TEST(Schemas, OfAKindStandAlone) {
    for (const Kind written : qm::allKinds) {
        const std::string kind = qm::kindName(written);
        const Json schema = parseJson(qm::standaloneSchema(kind));
        EXPECT_EQ(schema.at("properties").at("kind").at("const"), kind);
        const std::string text = schema.dump();
        constexpr const char* mark = R"("$ref":")";
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
            const std::string reference = text.substr(at + 8, text.find('"', at + 8) - at - 8);
            ASSERT_EQ(reference.substr(0, 14), "#/definitions/");
            EXPECT_TRUE(schema.at("definitions").contains(reference.substr(14))) << reference;
        }
    }
    EXPECT_THROW((void)qm::bundledSchema("spoon"), std::logic_error);
}

TEST(Schemas, DescribeTheDocumentsThatTheToolsWrite) {
    const qm::test::TemporaryFolder folder;
    const Json whole = sampleDocument(folder, Kind::surfaces).root;
    for (const Kind written : qm::allKinds) {
        const std::string kind = qm::kindName(written);
        const Json root = sampleDocument(folder, written).root;
        EXPECT_NO_THROW(qm::validateAgainstSchema(root, kind)) << kind;
        EXPECT_EQ(root.at("kind"), kind);
        // Removing a required key must be noticed.
        const Json schema = qm::bundledSchema(kind);
        for (const Json& key : schema.at("required")) {
            Json less = root;
            less.erase(key.get<std::string>());
            EXPECT_EQ(messageOf([&] { qm::validateAgainstSchema(less, kind); }),
                      "lacks '" + key.get<std::string>() + "'");
        }
    }
}

/// Replaces every scalar of a document by an object, which must be noticed unless the schema allows anything.
void spoil(const Json& root, const Json& value, const Json::json_pointer& pointer,
           std::vector<std::string>& accepted) {
    if (value.is_structured()) {
        std::size_t rank = 0;
        for (const auto& [key, member] : value.items())
            if (rank++ < 3) spoil(root, member, pointer / key, accepted);
        return;
    }
    Json spoilt = root;
    spoilt[pointer] = Json::object();
    try {
        qm::validateAgainstSchema(spoilt, root.at("kind"));
        accepted.push_back(pointer.to_string());
    } catch (const qm::Error& error) {
        EXPECT_EQ(std::string(error.what()).rfind(pointer.to_string() + ": ", 0), 0U) << error.what();
    }
}

TEST(Schemas, NoticeAWrongTypeAnywhere) {
    const qm::test::TemporaryFolder folder;
    const Json root = sampleDocument(folder, Kind::surfaces).root;
    std::vector<std::string> accepted;
    spoil(root, root, Json::json_pointer(), accepted);
    for (const std::string& pointer : accepted)
        EXPECT_EQ(pointer.rfind("/history/", 0), 0U) << pointer;
}

TEST(Validation, NamesThePlaceAlsoInLongLists) {
    const Json schema = parseJson(R"({"properties": {"labels": {"type": "array", "maxItems": 5000,
        "items": {"type": "integer", "minimum": 0, "maximum": 9}}}})");
    const auto complaint = [&](std::size_t index, const Json& value) {
        Json root{{"labels", std::vector<int>(5000, 3)}};
        root["labels"][index] = value;
        return messageOf([&] { qm::validate(root, schema); });
    };
    EXPECT_EQ(complaint(0, 4), "");
    EXPECT_EQ(complaint(0, 4.0), "");
    EXPECT_EQ(complaint(4321, -1), "/labels/4321: is less than 0");
    EXPECT_EQ(complaint(1234, 10), "/labels/1234: is more than 9");
    EXPECT_EQ(complaint(77, 3.5), "/labels/77: is number, not integer");
    EXPECT_EQ(complaint(4999, "x"), "/labels/4999: is string, not integer");
    EXPECT_NE(complaint(5000, 3), "");
}

TEST(Validation, IsFastAndStopsAtTheFirstError) {
    Json points = Json::array();
    for (int i = 0; i < 100000; ++i)
        points.push_back({0.5 * i, 1.5 * i, 2.5 * i});
    const Json root{{"points", points},
                    {"labels", std::vector<int>(1000000, 1)},
                    {"words", std::vector<int>(1000000, 1)}};
    const Json schema = parseJson(R"({"properties": {
        "points": {"items": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}},
        "labels": {"items": {"type": "integer", "minimum": 0}},
        "words": {"items": {"type": "string"}}}})");
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(messageOf([&] { qm::validate(root, schema); }), "/words/0: is number, not string");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(ShownElements, DecideForAllNumbers) {
    using Positions = std::vector<std::size_t>;
    const auto shown = [](const std::string& text) {
        return qm::shownElements(parseJson(text).get_ref<const Json::array_t&>());
    };
    EXPECT_EQ(shown("[3, 1, 2]"), (Positions{0, 1, 2}));
    EXPECT_EQ(shown("[5, 4, 3, 9, 4, 5, 6, 7, 1, 8]"), (Positions{8, 3}));
    EXPECT_EQ(shown("[5, 4, 3, 9, 4.5, 5, 6.5, 7, 1, 8]"), (Positions{4, 8, 3}));
    EXPECT_EQ(shown("[5, 4, 3, 9, null, 5, 6, 7, 1, 8]").size(), 10U);
}

} // namespace
