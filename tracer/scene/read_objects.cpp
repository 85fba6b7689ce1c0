#include "tracer/scene/read_objects.h"

#include "tracer/scene/bpt_file.h"
#include "tracer/scene/mesh.h"
#include "tracer/scene/read_solid.h"

namespace gnomon {
namespace {

constexpr int kToBeNamed = -2;  // what an object moves around, until all names are known
constexpr int kNoMaterial = -1; // yet: that of the group around, or in the end the default

bool isSeveral(const ObjectReader& object) {
    return object.has("group") || object.has("instance") || object.has("mesh") || object.has("surface");
}

} // namespace

ObjectsReader::ObjectsReader(const ObjectReader& root, const std::vector<Material>& materials,
                             const std::map<std::string, int>& materialNames, const SceneFiles& files,
                             SceneReport& report)
    : root_(root), materials_(materials), materialNames_(materialNames), files_(files), report_(report) {
    const auto members = root.members("definitions");
    for (const auto& member : members) definitions_.emplace(member.name, Definition{member, {}, {}});
    knowsDefinitions_ = root.readsAllOf("definitions", members);
}

std::vector<Object> ObjectsReader::read() {
    Target scene;
    for (const auto& object : root_.members("objects")) readObject(root_.open("objects", object), scene);
    scene.names.resolve(scene.objects, report_);
    for (auto& [name, definition] : definitions_) readDefinition(definition);
    if (knowsDefinitions_)
        unknownDefinitions_.report("definition", namesIn(definitions_), "define it under \"definitions\"", report_);
    for (Object& object : scene.objects) {
        if (object.material == kNoMaterial) object.material = 0;
        if (!materials_[std::size_t(object.material)].showsImages()) object.shape = unoriented(object.shape);
    }
    return std::move(scene.objects);
}

void ObjectsReader::reportUnknownMaterials() const {
    unknownMaterials_.report("material", namesIn(materialNames_), "define it under \"materials\"", report_);
}

void ObjectsReader::readDefinition(Definition& definition) {
    if (definition.state != Definition::State::New) return;
    definition.state = Definition::State::BeingRead;
    Target own;
    readObject(root_.open("definitions", definition.member), own);
    own.names.resolve(own.objects, report_);
    definition.objects = std::move(own.objects);
    definition.state = Definition::State::Read;
}

/// Appends what stands under the object; then its other keys bear on all of that.
void ObjectsReader::readObject(const ObjectReader& reader, Target& target) {
    const std::size_t from = target.objects.size();
    if (const auto group = reader.object("group")) readGroup(*group, target);
    if (const auto instance = reader.object("instance")) readInstance(*instance, target);
    if (const auto mesh = reader.object("mesh")) readMesh(*mesh, target);
    if (const auto surface = reader.object("surface")) readModel(*surface, ModelKind::Surface, target);
    if (isSeveral(reader)) readBlend(reader);
    if (!isSeveral(reader) && hasRoom(1, reader, target)) {
        Object& object = target.objects.emplace_back();
        object.line = reader.line();
        object.material = kNoMaterial;
        object.shape = readShape(reader, report_);
        target.names.name(reader, int(from), object.name, report_);
    }
    readMaterial(reader, from, target);
    bool castsShadow = true;
    if (reader.read("casts_shadow", castsShadow) && !castsShadow)
        for (std::size_t i = from; i < target.objects.size(); ++i) target.objects[i].castsShadow = false;
    readMotion(reader, from, target);
    readGlow(reader, from, target);
}

void ObjectsReader::readGroup(const ObjectReader& group, Target& target) {
    const std::size_t from = target.objects.size();
    for (const auto& member : group.members("of")) readObject(group.open("of", member), target);
    place(group, from, target);
}

void ObjectsReader::readInstance(const ObjectReader& instance, Target& target) {
    std::string name;
    if (!instance.read("of", name)) return;
    const auto found = definitions_.find(name);
    if (found == definitions_.end()) return unknownDefinitions_.add(name, instance.lineOf("of"), instance.pathOf("of"));
    Definition& definition = found->second;
    if (definition.state == Definition::State::BeingRead)
        return report_.add(instance.lineOf("of"), instance.pathOf("of"),
                           inQuotes(name) + " stands within itself in the end", "let a definition hold others only");
    readDefinition(definition);
    const std::size_t from = target.objects.size();
    if (!hasRoom(definition.objects.size(), instance, target)) return;
    for (Object object : definition.objects) {
        if (object.motion && object.motion->around >= 0) object.motion->around += int(from);
        object.name.clear(); // it is told apart within its definition only
        target.objects.push_back(std::move(object));
    }
    place(instance, from, target);
}

void ObjectsReader::readMesh(const ObjectReader& mesh, Target& target) {
    bool smooth = true;
    mesh.read("smooth", smooth);
    readModel(mesh, smooth ? ModelKind::SmoothMesh : ModelKind::FlatMesh, target);
}

std::variant<std::vector<Shape>, Complaint> ObjectsReader::modelOf(const Model& model) const {
    const auto& [file, kind] = model;
    const bool surface = kind == ModelKind::Surface;
    if (!files_)
        return Complaint{surface ? "a surface cannot be read here" : "a mesh cannot be read here",
                         surface ? "write its patches into the scene" : "write its triangles into the scene"};
    Problems problems;
    const auto bytes = files_(file, problems);
    if (bytes && surface) return patchesOf(*bytes, file, kMostObjects);
    if (bytes) return meshOf(*bytes, file, kind == ModelKind::SmoothMesh, kMostObjects);
    if (problems.empty()) return Complaint{inQuotes(file) + " is missing", "put it beside the scene"};
    return Complaint{inQuotes(file) + ": " + problems[0].what, problems[0].remedy};
}

/// Of a file that is no model the first mention is told.
void ObjectsReader::readModel(const ObjectReader& reader, ModelKind kind, Target& target) {
    std::string file;
    if (!reader.read("file", file) || full_) return;
    const auto [known, isNew] = models_.try_emplace({file, kind});
    if (isNew) {
        auto shapes = modelOf(known->first);
        if (const auto* complaint = std::get_if<Complaint>(&shapes))
            return report_.add(reader.lineOf("file"), reader.pathOf("file"), (*complaint)[0], (*complaint)[1]);
        known->second = std::get<std::vector<Shape>>(std::move(shapes));
    }
    if (!hasRoom(known->second.size(), reader, target)) return;
    for (const Shape& shape : known->second) {
        Object& object = target.objects.emplace_back();
        object.line = reader.line();
        object.material = kNoMaterial;
        object.shape = shape;
    }
}

/// Scales, rotates and moves the objects from `from` on. One that cannot be is told, and no others of the group.
void ObjectsReader::place(const ObjectReader& group, std::size_t from, Target& target) {
    const Placement placement = readPlacement(group);
    if (!group.sound()) return;
    const Affine map = affineOf(placement.scale, placement.rotate, placement.translate);
    for (std::size_t i = from; i < target.objects.size(); ++i) {
        Object& object = target.objects[i];
        // What moves around another rests relative to it: that has been moved, or is to be.
        const bool relative = object.motion && object.motion->around != -1;
        auto shape = transformed(object.shape, relative ? Affine{map.linear} : map);
        if (const auto* complaint = std::get_if<Complaint>(&shape))
            return report_.add(group.line(), group.path(),
                               "the object of line " + std::to_string(object.line) + ": " + (*complaint)[0],
                               (*complaint)[1]);
        object.shape = std::get<Shape>(std::move(shape));
        if (!object.motion) continue;
        object.motion->cos = map.linear * object.motion->cos;
        object.motion->sin = map.linear * object.motion->sin;
    }
}

/// Of those that have none from farther inside.
void ObjectsReader::readMaterial(const ObjectReader& object, std::size_t from, Target& target) {
    std::string name;
    if (!object.read("material", name)) return;
    const auto found = materialNames_.find(name);
    if (found == materialNames_.end())
        return unknownMaterials_.add(name, object.lineOf("material"), object.pathOf("material"));
    for (std::size_t i = from; i < target.objects.size(); ++i)
        if (int& material = target.objects[i].material; material == kNoMaterial) material = found->second;
}

void ObjectsReader::readMotion(const ObjectReader& object, std::size_t from, Target& target) {
    const auto motion = object.object("motion");
    const auto reader = motion ? motion->object("orbit") : std::nullopt;
    if (!reader) return;
    Orbit orbit;
    reader->read("cos", orbit.cos);
    reader->read("sin", orbit.sin);
    reader->read("rate", orbit.rate);
    std::string around;
    reader->read("around", around);
    for (std::size_t i = from; i < target.objects.size(); ++i) {
        if (target.objects[i].motion)
            return report_.add(reader->line(), reader->path(),
                               "the object of line " + std::to_string(target.objects[i].line) +
                                   " moves already within what moves here",
                               "let one of them rest");
        target.objects[i].motion = orbit;
        if (around.empty()) continue;
        target.objects[i].motion->around = kToBeNamed;
        target.names.moveAround(int(i), around, reader->lineOf("around"), reader->pathOf("around"));
    }
}

void ObjectsReader::readGlow(const ObjectReader& object, std::size_t from, Target& target) {
    const auto reader = object.object("glow");
    if (!reader) return;
    Glow glow;
    reader->read("color", glow.color);
    reader->read("strength", glow.strength);
    reader->read("softness", glow.softness);
    if (isSeveral(object) || from == target.objects.size() || target.objects[from].shape.kind != ShapeKind::Sphere)
        return;
    target.objects[from].glow = glow;
}

/// Those of definitions count as well: they take memory, however few are drawn.
bool ObjectsReader::hasRoom(std::size_t more, const ObjectReader& reader, const Target& target) {
    if (full_) return false;
    made_ += more;
    full_ = target.objects.size() + more > kMostObjects || made_ > 2 * kMostObjects;
    if (full_)
        report_.add(reader.line(), reader.path(),
                    "with this the scene has more than " + toString(kMostObjects) +
                        " objects, as groups, instances "
                        "and meshes make them",
                    "use fewer or smaller ones");
    return !full_;
}

} // namespace gnomon
