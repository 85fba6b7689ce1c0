/// The names of objects, and of those that others move around.
#pragma once

#include "tracer/scene/object_reader.h"
#include "tracer/scene/scene.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gnomon {

/// Names that stand for nothing: each is one problem, however often it stands in the file.
class UnknownNames {
  public:
    void add(const std::string& name, int line, std::string path);
    /// In the order of the file.
    void report(std::string_view what, const std::vector<std::string_view>& known, const char* remedy,
                SceneReport&) const;

  private:
    struct Unknown {
        std::string name;
        int line;
        std::string path;
        int more = 0;
    };
    std::map<std::string, int> places_; ///< in `all_`
    std::vector<Unknown> all_;
};

/// Of a scene, or of a definition, whose names stand for its own objects only.
class ObjectNames {
  public:
    /// Object `index` is called what its file says.
    void name(const ObjectReader& object, int index, std::string& name, SceneReport&);
    /// Object `index` moves around that of `name`, which may be told later in the file.
    void moveAround(int index, const std::string& name, int line, std::string path) {
        centres_.push_back({index, name, line, std::move(path)});
    }
    /// Once all are named: sets what they move around, and refuses circles.
    void resolve(std::vector<Object>&, SceneReport&) const;

  private:
    void refuseCircles(const std::vector<Object>&, SceneReport&) const;

    struct Centre {
        int object;
        std::string name;
        int line;
        std::string path;
    };
    std::map<std::string, std::pair<int, std::string>> named_; ///< index, and path in the file
    std::vector<Centre> centres_;
};

/// In an order that does not depend on the library.
template<class Value>
std::vector<std::string_view> namesIn(const std::map<std::string, Value>& table) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : table) names.push_back(name);
    return names;
}

} // namespace gnomon
