/// Reads one object of a scene file by its format: what does not fit the format is reported, what fits is handed over.
///
/// Construction reports unknown keys, missing keys and wrong alternatives; each read() reports what is wrong with its
/// value. A value that is absent or wrong leaves the target as it was, so that reading goes on and finds the next
/// problem.
#pragma once

#include "tracer/problem.h"
#include "tracer/scene/json_document.h"
#include "tracer/scene/scene_format.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// Where the problems of one file go.
struct SceneReport {
    ProblemCounter& problems;
    std::size_t lettersLeft = 200'000'000; ///< to compare in search of suggestions: less than a second's work

    void add(int line, std::string path, std::string what, std::string remedy = {});

    /// `did you mean "WORD"?`, or `otherwise`.
    std::string suggest(std::string_view word, const std::vector<std::string_view>& candidates, std::string otherwise);
};

class ObjectReader {
  public:
    ObjectReader(const JsonValue&, const ObjectFormat&, std::string path, SceneReport&);

    int line() const { return value_->line; }
    int lineOf(std::string_view key) const;
    const std::string& path() const { return path_; }
    std::string pathOf(std::string_view key) const { return memberPath(path_, key); }
    bool has(std::string_view key) const { return value_->find(key) != nullptr; }
    /// Whether nothing has been reported since construction: only then do checks across fields make sense.
    bool sound() const { return report_->problems.count() == problemsBefore_; }

    // Each is true where the key is there and its value fits.
    bool read(std::string_view key, bool&) const;
    bool read(std::string_view key, double&) const;
    bool read(std::string_view key, std::string&) const;
    bool read(std::string_view key, glm::dvec2&) const;
    bool read(std::string_view key, glm::dvec3&) const;
    bool read(std::string_view key, std::array<glm::dvec3, 2>&) const;
    bool read(std::string_view key, std::array<glm::dvec3, 3>&) const;
    bool read(std::string_view key, std::array<double, 16>&) const;
    bool read(std::string_view key, std::array<glm::dvec4, 16>&) const;

    /// The reader of the object under `key`; none where the key is absent.
    std::optional<ObjectReader> object(std::string_view key) const;
    /// The same where an image's name may stand instead: that goes to `image`.
    std::optional<ObjectReader> objectOrImage(std::string_view key, std::string& image) const;
    /// Readers of a list's or map's objects. The name is empty in lists.
    struct Member {
        std::string name;
        const JsonValue* value;
        std::string path;
    };
    std::vector<Member> members(std::string_view key) const;
    /// Whether `read`, the members of the map under `key`, are all that the file names. Else the map as a whole is
    /// wrong or its key misspelt, which has been told: then no name is called unknown.
    bool readsAllOf(std::string_view key, const std::vector<Member>& read) const;
    ObjectReader open(std::string_view key, const Member&) const;

  private:
    const Alternatives* unmetAlternatives() const;
    bool looksLikeOneOf(const Alternatives&, const JsonValue& member) const;
    void reportUnknownKeys() const;
    void reportMissingKeys() const;
    void reportAlternatives() const;
    void reportExclusions() const;

    const JsonValue* value_;
    const ObjectFormat* format_;
    std::string path_;
    SceneReport* report_;
    std::size_t problemsBefore_;
};

} // namespace gnomon
