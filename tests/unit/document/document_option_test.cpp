/// \file One table per options struct feeds the command line, the help and the history.
#include "cli/options/option_record.h"
#include "document/options/options_json.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using qm::Json;
using qm::OptionRecord;
using qm::Range;

TEST(Options, AreRecordedAsTheyAreInEffect) {
    qm::PruneOptions prune;
    prune.eta = -3;
    EXPECT_EQ(qm::optionsToJson(prune), Json({{"method", "greedy"},
                                              {"eta", -3.0},
                                              {"smooth", true},
                                              {"maxTurn", 25.0},
                                              {"minCorner", 25.0},
                                              {"maxSharpTurn", 35.0},
                                              {"beta", 1.0},
                                              {"fewestPatches", false},
                                              {"maxSegments", nullptr},
                                              {"timeLimit", 60.0},
                                              {"front", false}}));
    const Json search = qm::optionsToJson(qm::EnumerationOptions{});
    EXPECT_EQ(search["method"], "optimum");
    EXPECT_TRUE(search["timeLimit"].is_null());
    EXPECT_TRUE(search["maxCost"].is_null());
    EXPECT_EQ(search["best"], 1);
}

TEST(Options, KeysAreNamesWithoutDashes) {
    EXPECT_EQ(qm::keyOf("max-turn"), "maxTurn");
    EXPECT_EQ(qm::keyOf("samples-per-edge"), "samplesPerEdge");
    EXPECT_EQ(qm::keyOf("rho"), "rho");
}

TEST(Options, RangesReadLikeText) {
    EXPECT_EQ(qm::rangeText({}), "");
    EXPECT_EQ(qm::rangeText({0, 180}), "0 to 180");
    EXPECT_EQ(qm::rangeText({1, 1e9}), "1 to 1000000000");
    EXPECT_EQ(qm::rangeText({0, 3.141592653589793}), "0 to 3.14159");
    EXPECT_EQ(qm::rangeText({1, qm::infinity}), "at least 1");
    EXPECT_EQ(qm::rangeText({-qm::infinity, 2.5}), "at most 2.5");
}

/// Checks for every option of a module that its default is allowed, its help is not empty, and its name is
/// unique.
template <class Options> void verifyTable(Options options) {
    std::set<std::string> names;
    qm::describe(options, [&](const char* name, auto& value, const Range& range, const char* help) {
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_GT(std::string(help).size(), 5U) << name;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
            EXPECT_GE(static_cast<double>(value), range.min) << name;
            EXPECT_LE(static_cast<double>(value), range.max) << name;
        }
        const OptionRecord record = qm::makeOption(name, value, range, help);
        if (record.type == OptionRecord::Type::flag || record.defaultText.empty()) return;
        const Value before = value;
        EXPECT_EQ(record.assign(record.defaultText), "") << name;
        EXPECT_EQ(before, value) << name;
        EXPECT_EQ(record.show(), record.defaultText) << name;
    });
    EXPECT_EQ(qm::optionsToJson(options).size(), names.size());
}

TEST(Options, OfEveryModuleAreSound) {
    verifyTable(qm::FeatureOptions{});
    verifyTable(qm::CutOptions{});
    verifyTable(qm::EnumerationOptions{});
    verifyTable(qm::MergeOptions{});
    verifyTable(qm::PruneOptions{});
    verifyTable(qm::FitOptions{});
}

TEST(OptionRecord, TakesToleranceAsLengthOrShare) {
    qm::Length tolerance{0.1, true};
    const OptionRecord record = qm::makeOption("tolerance", tolerance, {1e-300, 1e300}, "help");
    EXPECT_EQ(record.defaultText, "0.1%");
    EXPECT_EQ(record.assign("0.5%"), "");
    EXPECT_EQ(tolerance.length(200), 1);
    EXPECT_EQ(record.assign("0.5"), "");
    EXPECT_EQ(tolerance.length(200), 0.5);
    for (const char* bad : {"", "%", "0%", "-1", "1 %", "1%%", "inf", "x"})
        EXPECT_NE(record.assign(bad), "") << bad;
    EXPECT_EQ(record.show(), "0.5");

    const OptionRecord length = qm::makeOption("min-length", tolerance, {0, 1e300}, "help");
    EXPECT_EQ(length.assign("0%"), "");
    EXPECT_EQ(length.show(), "0%");
    EXPECT_EQ(length.assign("-1%"), "'-1%' is no number from 0, with or without %");
}

TEST(OptionRecord, RefusesWhatIsNoNumberOrOutOfRange) {
    double real = 0.5;
    const OptionRecord number = qm::makeOption("rho", real, {0, 3}, "help");
    EXPECT_EQ(number.assign("2.5"), "");
    EXPECT_EQ(real, 2.5);
    EXPECT_EQ(number.assign("4"), "4 is out of range, 0 to 3");
    for (const char* text : {"nan", "inf", "", "1x", "0x1p3", "1,5"})
        EXPECT_EQ(number.assign(text), "'" + std::string(text) + "' is no number");
    EXPECT_EQ(real, 2.5);

    std::size_t whole = 7;
    const OptionRecord count = qm::makeOption("best", whole, {1, 10}, "help");
    EXPECT_EQ(count.defaultText, "7");
    EXPECT_EQ(count.assign("10"), "");
    EXPECT_EQ(whole, 10U);
    EXPECT_EQ(count.assign("2.5"), "'2.5' is no whole number");
    EXPECT_EQ(count.assign("-1"), "'-1' is no whole number");
    EXPECT_EQ(count.assign("99999999999999999999999"), "'99999999999999999999999' is no whole number");
    EXPECT_EQ(count.assign("11"), "11 is out of range, 1 to 10");
}

TEST(OptionRecord, AFlagTurnsItsDefaultRound) {
    bool on = true;
    bool off = false;
    const OptionRecord smooth = qm::makeOption("smooth", on, {}, "help");
    const OptionRecord count = qm::makeOption("count", off, {}, "help");
    EXPECT_EQ(smooth.name, "no-smooth");
    EXPECT_EQ(count.name, "count");
    EXPECT_EQ(smooth.assign("") + count.assign(""), "");
    EXPECT_FALSE(on);
    EXPECT_TRUE(off);
}

TEST(OptionRecord, AChoiceIsOneOfItsNames) {
    qm::Method method = qm::Method::optimum;
    const OptionRecord record = qm::makeOption("method", method, {}, "help");
    EXPECT_EQ(record.defaultText, "optimum");
    EXPECT_EQ(record.assign("improved"), "");
    EXPECT_EQ(method, qm::Method::improved);
    EXPECT_EQ(record.assign("best"), "'best' is none of optimum, naive, bounds, improved, plain");
}

} // namespace
