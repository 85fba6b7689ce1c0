#include "tracer/plan/prepared_scene.h"

#include "tracer/accel/bounds.h"
#include "tracer/accel/hierarchy.h"
#include "tracer/plan/drawn.h"

#include <atomic>
#include <utility>

namespace gnomon {
namespace {

std::atomic<int> preparations = 0;

std::vector<Shape> shapesAtRest(const Scene& scene, glm::dvec3 origin) {
    std::vector<Shape> shapes = shapesAt(scene, 0);
    for (Shape& shape : shapes) shape = translated(shape, -origin);
    return shapes;
}

SearchCost searchCostOf(const KindLayout& kind, const std::vector<Shape>& shapes) {
    SearchCost cost;
    if (!shapeRow(kind.kind).extent) return cost;
    std::vector<Bounds> bounds;
    for (auto i = kind.objects.begin() + kind.latticeMembers(); i != kind.objects.end(); ++i)
        bounds.push_back(*boundsOf(shapes[std::size_t(*i)]));
    cost.objects = int(bounds.size());
    const Hierarchy hierarchy = build(bounds);
    cost.boxes = hierarchy.cost();
    cost.primitives = hierarchy.primitivesAsked();
    cost.grid = planGrid(bounds);
    return cost;
}

/// By world axes in GL's order, of which x is mirrored: cube maps are left-handed, scenes are not.
std::vector<std::string> facesOf(const Background& background) {
    std::vector<std::string> faces;
    if (background.cubemap.empty()) return faces;
    for (const char* side : {"-nx", "-px", "-py", "-ny", "-pz", "-nz"}) faces.push_back(background.cubemap + side);
    return faces;
}

} // namespace

PreparedScenePtr prepare(Scene scene) {
    ++preparations;
    PreparedScene prepared;
    prepared.origin = originOf(scene);
    prepared.shapes = shapesAtRest(scene, prepared.origin);
    prepared.layout = layoutOf(scene, prepared.shapes);
    for (const KindLayout& kind : prepared.layout) prepared.searches.push_back(searchCostOf(kind, prepared.shapes));
    prepared.media = mediaOf(scene);
    prepared.textureSet = textureSetOf(scene);
    prepared.skyFaces = facesOf(scene.background);
    prepared.moves = changesWithTime(scene);
    prepared.scene = std::move(scene);
    return std::make_shared<const PreparedScene>(std::move(prepared));
}

int preparedScenes() { return preparations; }

} // namespace gnomon
