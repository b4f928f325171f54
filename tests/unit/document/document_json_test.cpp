/// \file Reading and printing JSON.
#include "base/infinity.h"
#include "base/number_text.h"
#include "document/json/json.h"
#include "document/json/json_place.h"
#include "document/json/utf8.h"
#include "document/schema/misspelt_keys.h"
#include "support/message_of.h"
#include "support/sample_document.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <random>
#include <stdexcept>

namespace {

using qm::Json;
using qm::parseJson;
using qm::printJson;
using qm::test::messageOf;

std::string refusal(const std::string& text) {
    return messageOf([&] { (void)parseJson(text); });
}

TEST(ParseJson, ReadsEveryTypeAndKeepsTheOrderOfKeys) {
    const Json value = parseJson(R"({"z": [1, -2, 2.5, true, null], "a": "\u00e4\n", "m": {}})");
    EXPECT_EQ(value.dump(), R"({"z":[1,-2,2.5,true,null],"a":"ä\n","m":{}})");
}

TEST(ParseJson, SaysWhereTheTextIsWrong) {
    EXPECT_EQ(refusal("{\n  \"a\": 1,\n  b: 2\n}").substr(0, 17), "line 3, column 3:");
    EXPECT_NE(refusal("{\"kind\": layout}").find("line 1, column 10"), std::string::npos);
    EXPECT_NE(refusal("[1, 2").find("is no JSON"), std::string::npos);
    EXPECT_NE(refusal("{\"a\": 1} {\"b\": 2}").find("expected end of input"), std::string::npos);
    EXPECT_NE(refusal("1e999").find("overflow"), std::string::npos);
    EXPECT_NE(refusal("{\"a\": \"lay\x80out\"}").find("UTF-8"), std::string::npos);
    EXPECT_NE(refusal("[NaN]").find("line 1"), std::string::npos);
}

TEST(ParseJson, EmptyTextMeansThatThePipeBroke) {
    for (const std::string text : {"", " ", "\n\n"})
        EXPECT_EQ(refusal(text), "is empty. Perhaps the tool before it in the pipe failed");
}

TEST(ParseJson, RefusesAKeyThatOccursTwice) {
    EXPECT_EQ(refusal(R"({"a": [0, {"b": 1, "c": 2, "b": 3}]})"),
              "/a/1/b: this key occurs twice in one object");
    std::string many = "{";
    for (int i = 0; i < 100; ++i)
        many += "\"k" + std::to_string(i) + "\": 0, ";
    EXPECT_NO_THROW((void)parseJson(many + "\"k100\": 0}"));
    EXPECT_EQ(refusal(many + "\"k7\": 0}"), "/k7: this key occurs twice in one object");
}

TEST(ParseJson, RefusesWhatIsNestedTooDeep) {
    EXPECT_NO_THROW((void)parseJson(std::string(100, '[') + std::string(100, ']')));
    EXPECT_NE(refusal(std::string(1000000, '[')).find("nested more than 100 deep"), std::string::npos);
}

TEST(ParseJson, TakesLinearTimeForManyKeys) {
    std::string text = "{";
    for (int i = 0; i < 200000; ++i)
        text += "\"key" + std::to_string(i) + "\": 0, ";
    text += "\"last\": 0}";
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(parseJson(text).size(), 200001U);
    // Searching all keys for every new key would take minutes.
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Members, AreNotCopiedWhenOthersAreAdded) {
    Json object{{"list", {1, 2, 3}}};
    const Json* const first = &object["list"][0];
    for (int i = 0; i < 100; ++i)
        object["key" + std::to_string(i)] = i;
    EXPECT_EQ(&object["list"][0], first);
}

TEST(Members, KeepTheirOrderAndTheFirstValueOfAKey) {
    Json object = Json::object();
    for (const char* key : {"z", "a", "m", "a"})
        object.emplace(key, object.size());
    EXPECT_EQ(object.dump(), R"({"z":0,"a":1,"m":2})");
    object["a"] = 5;
    object.erase("z");
    EXPECT_EQ(object.dump(), R"({"a":5,"m":2})");
}

TEST(MisspeltKeys, ResembleAKnownKeyThatIsMissing) {
    const Json root = parseJson(R"({"kind": "layout", "version": 1, "histroy": [], "Kind": 0, "": 0})");
    EXPECT_EQ(qm::misspeltKeys(root, "layout"),
              std::vector<std::string>{"/histroy: no tool reads this key. Is it 'history'?"});
}

TEST(MisspeltKeys, TakeLinearTimeForManyKeys) {
    Json root = Json::object();
    for (int i = 0; i < 400'000; ++i) // in quadratic time, a quarter of an hour
        root.get_ref<Json::object_t&>().append("foreign" + std::to_string(i), 0);
    EXPECT_TRUE(qm::misspeltKeys(root, "layout").empty());
}

TEST(PrintJson, ReadsBackAsTheSame) {
    std::mt19937_64 random(1);
    Json numbers = Json::array();
    for (int i = 0; i < 2000; ++i) {
        double number = 0;
        const std::uint64_t bits = random();
        std::memcpy(&number, &bits, sizeof number);
        if (std::isfinite(number)) numbers.push_back(number);
    }
    const Json value{{"numbers", numbers},
                     {"large", std::numeric_limits<std::uint64_t>::max()},
                     {"small", std::numeric_limits<std::int64_t>::min()},
                     {"text", std::string("\x01\x1f\"\\/\b\f\n\r\tä€😀")},
                     {"nested", {{{"a", Json::array()}, {"b", Json::object()}}}}};
    const std::string text = printJson(value);
    EXPECT_EQ(parseJson(text), value);
    EXPECT_EQ(printJson(parseJson(text)), text);
}

TEST(PrintJson, NumbersAreAsShortAsCanBe) {
    EXPECT_EQ(printJson(0.1), "0.1\n");
    EXPECT_EQ(printJson(2.0), "2\n");
    EXPECT_EQ(printJson(-0.0), "0\n");
    EXPECT_EQ(printJson(1e300), "1e+300\n");
}

TEST(PrintJson, NeverWritesWhatIsNoNumber) {
    EXPECT_THROW((void)printJson(std::numeric_limits<double>::quiet_NaN()), std::logic_error);
    EXPECT_THROW((void)printJson(Json::array({qm::infinity})), std::logic_error);
}

TEST(PrintJson, IsLaidOutForPeople) {
    Json list = Json::array();
    for (int i = 0; i < 40; ++i)
        list.push_back(1000 + i);
    const Json value{{"curves", {{{"id", 0}, {"vertices", {1, 2, 3}}}, {{"id", 1}, {"vertices", list}}}}};
    EXPECT_EQ(printJson(value), R"({
  "curves": [
    {"id": 0, "vertices": [1, 2, 3]},
    {
      "id": 1,
      "vertices": [
        1000, 1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009, 1010, 1011, 1012, 1013, 1014,
        1015, 1016, 1017, 1018, 1019, 1020, 1021, 1022, 1023, 1024, 1025, 1026, 1027, 1028, 1029,
        1030, 1031, 1032, 1033, 1034, 1035, 1036, 1037, 1038, 1039
      ]
    }
  ]
}
)");
    EXPECT_EQ(qm::printJsonLine(value["curves"][0]), "{\"id\": 0, \"vertices\": [1, 2, 3]}\n");
}

TEST(JsonPlace, NamesThePlaceOfEveryComplaint) {
    const Json value = parseJson(R"({"a/b": [{"n": 1.5, "t": "x", "list": [0, 3, -1]}]})");
    const auto entry = qm::JsonPlace(value)["a/b"][0];
    EXPECT_EQ(messageOf([&] { (void)entry["n"].whole(); }), "/a~1b/0/n: is no whole number");
    EXPECT_EQ(messageOf([&] { (void)entry["t"].number(); }), "/a~1b/0/t: is string, not number");
    EXPECT_EQ(messageOf([&] { (void)entry["x"]; }), "/a~1b/0: lacks 'x'");
    EXPECT_EQ(messageOf([&] { (void)entry["list"].indices(3, "vertex"); }),
              "/a~1b/0/list/1: there is no vertex 3, only 0 to 2");
    EXPECT_EQ(messageOf([&] { (void)entry["list"].indices(4, "vertex"); }),
              "/a~1b/0/list/2: there is no vertex -1, only 0 to 3");
    EXPECT_EQ(messageOf([&] { (void)entry["list"][3]; }), "/a~1b/0/list: has only 3 entries");
    EXPECT_EQ(messageOf([&] { (void)qm::JsonPlace(value).number(); }), "/: is object, not number");
}

TEST(JsonPlace, TakesWholeNumbersHoweverTheyAreWritten) {
    EXPECT_EQ(qm::JsonPlace(parseJson("7.0")).whole(), 7);
    EXPECT_EQ(messageOf([] { (void)qm::JsonPlace(parseJson("1e30")).whole(); }), "/: is no whole number");
    EXPECT_EQ(messageOf([] { (void)qm::JsonPlace(parseJson("18446744073709551615")).whole(); }),
              "/: is no whole number");
}

TEST(FirstDifference, IgnoresForeignKeysAndTheFormOfNumbers) {
    const Json expected = parseJson(R"({"a": [1, 2], "b": {"c": true}})");
    const auto difference = [&](const std::string& text) {
        const auto place = qm::firstDifference(expected, parseJson(text));
        return place ? place->to_string() : "none";
    };
    EXPECT_EQ(difference(R"({"b": {"c": true, "mine": 1}, "a": [1.0, 2], "mine": 2})"), "none");
    EXPECT_EQ(difference(R"({"a": [1, 3], "b": {"c": true}})"), "/a/1");
    EXPECT_EQ(difference(R"({"a": [1, 2, 3], "b": {"c": true}})"), "/a/2");
    EXPECT_EQ(difference(R"({"a": [1, 2], "b": {}})"), "/b/c");
    EXPECT_EQ(difference(R"({"a": [1, 2], "b": 5})"), "/b");
}

TEST(Utf8, TellsGoodFromBad) {
    for (const std::string good : {"", "abc", "ä€😀", "\xF4\x8F\xBF\xBF"})
        EXPECT_TRUE(qm::isUtf8(good)) << good;
    for (const std::string bad : {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80",
                                  "\xF4\x90\x80\x80", "\xFF", "\xE2\x82", "a\xC3(b"})
        EXPECT_FALSE(qm::isUtf8(bad)) << bad;
}

TEST(ParseNumber, TakesNothingButAWholeFiniteNumber) {
    double number = 0;
    EXPECT_TRUE(qm::parseNumber("-2.5e3", number));
    EXPECT_EQ(number, -2500);
    for (const char* text : {"", " 1", "1 ", "nan", "inf", "1e999", "0x10", "1,5", "--1"})
        EXPECT_FALSE(qm::parseNumber(text, number)) << text;
    int whole = 0;
    EXPECT_TRUE(qm::parseNumber("12", whole));
    for (const char* text : {"1.0", "99999999999", "1e3"})
        EXPECT_FALSE(qm::parseNumber(text, whole)) << text;
}

} // namespace
