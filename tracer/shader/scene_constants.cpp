#include "tracer/shader/scene_constants.h"

#include "tracer/accel/hierarchy.h"
#include "tracer/plan/scene_offsets.h"

namespace gnomon {
namespace {

using Constants = std::vector<std::pair<std::string, int>>;

void addGeometry(const KindCount& kind, const KindOffsets& at, Constants& constants) {
    const std::string name = "k" + kind.type();
    constants.insert(constants.end(), {{name + "Base", at.geometry},
                                       {name + "Texels", kind.texels()},
                                       {name + "First", at.first},
                                       {name + "End", at.first + kind.count},
                                       {name + "Count", kind.count},
                                       {name + "Casters", kind.casters}});
}

void addSearches(const KindCount& kind, const KindOffsets& at, Constants& constants) {
    const std::string name = "k" + kind.type();
    const auto add = [&](const char* what, int value) { constants.emplace_back(name + what, value); };
    const auto addCells = [&](const std::string& what, int texel, glm::ivec3 count) {
        constants.insert(constants.end(), {{name + what, texel},
                                           {name + what + "X", count.x},
                                           {name + what + "Y", count.y},
                                           {name + what + "Z", count.z}});
    };
    if (kind.latticeMembers() > 0) addCells("Lattice", at.lattice, kind.lattice);
    if (kind.search == Search::Hierarchy) {
        add("Quantisation", at.hierarchy);
        add("Nodes", nodesFor(kind.loose()));
    }
    if (kind.search == Search::Grid) addCells("Grid", at.grid, kind.grid.count);
    if (kind.latticeMembers() > 0 || kind.search != Search::Loop) add("Loose", kind.latticeMembers());
}

} // namespace

std::vector<std::pair<std::string, int>> constantsOf(const SceneFeatures& features) {
    const SceneOffsets at = offsetsOf(features);
    Constants constants;
    for (std::size_t k = 0; k < features.shapes.size(); ++k) addGeometry(features.shapes[k], at.kinds[k], constants);
    for (std::size_t k = 0; k < features.shapes.size(); ++k) addSearches(features.shapes[k], at.kinds[k], constants);
    const auto addList = [&](const std::string& name, int base, int count) {
        constants.insert(constants.end(), {{name + "Base", base}, {name + "Count", count}});
    };
    addList("kObject", at.objects, features.objects());
    addList("kMaterial", at.materials, features.materials);
    addList("kLight", at.lights, features.lights);
    if (features.glows > 0) addList("kGlow", at.glows, features.glows);
    if (features.metals()) constants.emplace_back("kMetalBase", at.metals);
    if (features.media > 0) addList("kMedia", at.media, features.media);
    if (features.checkers) constants.emplace_back("kCheckerBase", at.checkers);
    if (features.lightProfiles) constants.emplace_back("kProfileBase", at.profiles);
    if (features.gradient) constants.emplace_back("kGradientBase", at.gradient);
    constants.emplace_back("kSceneTexels", at.end);
    return constants;
}

} // namespace gnomon
