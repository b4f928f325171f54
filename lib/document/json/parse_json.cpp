#include "base/error.h"
#include "document/json/json.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <unordered_set>

namespace qm {

namespace {

constexpr std::size_t maxDepth = 100;

/// Builds a value from the parser's events. The library's own builder would keep the last of duplicate keys,
/// and search all keys of an object for every new key.
class Builder {
public:
    using number_integer_t = Json::number_integer_t;
    using number_unsigned_t = Json::number_unsigned_t;
    using number_float_t = Json::number_float_t;
    using string_t = Json::string_t;
    using binary_t = Json::binary_t;

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(number_integer_t value) { return put(value); }
    bool number_unsigned(number_unsigned_t value) { return put(value); }
    bool number_float(number_float_t value, const string_t&) { return put(value); }
    bool string(string_t& value) { return put(std::move(value)); }
    bool binary(binary_t&) { return false; }
    bool start_array(std::size_t) { return open(false); }
    bool start_object(std::size_t) { return open(true); }
    bool key(string_t& key);
    bool end_array() { return close(); }
    bool end_object() { return close(); }
    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::json::exception& exception);

    Json result;
    std::string problem;
    std::size_t position = 0; ///< byte position of the problem; 0 if only its pointer is known
    JsonPointer pointer;

private:
    struct Level {
        bool isObject = false;
        Json::array_t elements;
        Json::object_t members;
        std::string key;                       ///< key of the next member
        std::unordered_set<std::string> known; ///< only for large objects
    };

    bool open(bool isObject) {
        if (levels_.size() >= maxDepth) return fail("nested more than " + std::to_string(maxDepth) + " deep");
        levels_.emplace_back().isObject = isObject;
        return true;
    }
    bool close() {
        Level level = std::move(levels_.back());
        levels_.pop_back();
        return level.isObject ? put(std::move(level.members)) : put(std::move(level.elements));
    }
    template <class Value> bool put(Value&& value) {
        if (levels_.empty()) {
            result = std::forward<Value>(value);
            return true;
        }
        Level& level = levels_.back();
        if (level.isObject) // the base class's function does not search for the key
            level.members.Json::object_t::Container::emplace_back(std::move(level.key),
                                                                  std::forward<Value>(value));
        else
            level.elements.emplace_back(std::forward<Value>(value));
        return true;
    }
    bool fail(std::string what) {
        problem = std::move(what);
        for (const Level& level : levels_)
            pointer /= level.isObject ? level.key : std::to_string(level.elements.size());
        return false;
    }

    std::vector<Level> levels_;
};

bool Builder::key(string_t& key) {
    constexpr std::size_t small = 16;
    Level& level = levels_.back();
    const auto sameKey = [&key](const auto& member) { return member.first == key; };
    bool isNew = true;
    if (level.members.size() < small) {
        isNew = std::ranges::none_of(level.members, sameKey);
    } else {
        if (level.known.empty())
            for (const auto& member : level.members)
                level.known.insert(member.first);
        isNew = level.known.insert(key).second;
    }
    level.key = std::move(key);
    return isNew || fail("this key occurs twice in one object");
}

/// The library's message, shortened, without its exception number and position.
std::string reason(std::string message) {
    constexpr std::size_t longest = 200;
    constexpr std::array<std::string_view, 4> marks{"] ", "parse error at ", ": ",
                                                    "syntax error while parsing "};
    for (const std::string_view mark : marks) {
        const std::size_t found = message.find(mark);
        if (found < 100) message.erase(0, found + mark.size());
    }
    return message.size() <= longest ? message : message.substr(0, longest) + " ...";
}

bool Builder::parse_error(std::size_t where, const std::string&, const nlohmann::json::exception& exception) {
    position = where;
    return fail("is no JSON: " + reason(exception.what()));
}

/// Line and column of a byte, which is counted from 1.
std::string lineAndColumn(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t lineStart = before.rfind('\n');
    const std::size_t column =
        lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

} // namespace

Json parseJson(std::string_view text) {
    if (std::ranges::all_of(text, [](unsigned char c) { return std::isspace(c) != 0; }))
        throw Error("", "is empty", "Perhaps the tool before it in the pipe failed");
    Builder builder;
    if (!Json::sax_parse(text.begin(), text.end(), &builder))
        throw Error(builder.position > 0 ? lineAndColumn(text, builder.position)
                                         : builder.pointer.to_string().substr(0, 100),
                    builder.problem);
    return std::move(builder.result);
}

} // namespace qm
