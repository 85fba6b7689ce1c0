#include "tracer/scene/read_scene.h"

#include "tracer/scene/object_reader.h"
#include "tracer/scene/read_solid.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gnomon {

namespace {

/// Names that stand for nothing: each is one problem, however often it stands in the file.
class UnknownNames {
  public:
    void add(const std::string& name, int line, std::string path) {
        const auto [at, isNew] = places_.emplace(name, int(all_.size()));
        if (isNew)
            all_.push_back({name, line, std::move(path)});
        else
            ++all_[std::size_t(at->second)].more;
    }
    /// In the order of the file.
    void report(std::string_view what, const std::vector<std::string_view>& known, const char* remedy,
                SceneReport& report) const {
        for (const auto& [name, line, path, more] : all_) {
            const std::string others =
                more == 1 ? ", here and in another object" : ", here and in " + std::to_string(more) + " other objects";
            report.add(line, path, "unknown " + std::string(what) + " " + inQuotes(name) + (more > 0 ? others : ""),
                       report.suggest(name, known, remedy));
        }
    }

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

/// Reads the parts of one file into a scene. What a single value may be stands in the format tables; here stands what
/// the parts mean together.
class SceneReader {
  public:
    explicit SceneReader(ProblemCounter& problems) : report_{problems} { scene_.file = problems.file(); }

    Scene read(const JsonValue& document);

  private:
    bool readMaterials(const ObjectReader& root, const JsonValue& document);
    void readCamera(const ObjectReader&);
    void readBackground(const ObjectReader&);
    void readLight(const ObjectReader&);
    void readMaterial(const ObjectReader&, const std::string& name);
    void readOptics(const ObjectReader&, Material&);
    std::optional<TextureUse> readTexture(const ObjectReader&, std::string_view key);
    void readObject(const ObjectReader&);
    void readMaterialName(const ObjectReader&, Object&);
    void readName(const ObjectReader&, Object&);
    void readMotion(const ObjectReader&, Object&);
    void readGlow(const ObjectReader&, Object&);
    void resolveCentres();
    void refuseCircles();

    /// Where an object's motion names the object it moves around, until all names are known.
    struct Centre {
        int object;
        std::string name;
        int line;
        std::string path;
    };

    SceneReport report_;
    Scene scene_;
    std::map<std::string, int> materials_, objects_; ///< by name
    UnknownNames unknownMaterials_;
    std::vector<Centre> centres_;
};

std::string stem(const std::string& file) {
    const std::size_t slash = file.find_last_of("/\\");
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    return name.substr(0, name.rfind('.'));
}

std::vector<std::string_view> namesIn(const std::map<std::string, int>& table) {
    std::vector<std::string_view> names;
    for (const auto& [name, index] : table) names.push_back(name);
    std::sort(names.begin(), names.end()); // messages must not depend on the order of a hash table
    return names;
}

Material defaultMaterial() {
    Material grey;
    grey.ambient = glm::dvec3(0.1);
    grey.diffuse = glm::dvec3(0.5);
    return grey;
}

Scene SceneReader::read(const JsonValue& document) {
    const ObjectReader root(document, sceneFormat(), "", report_);
    scene_.name = stem(scene_.file);
    root.read("title", scene_.title);
    root.read("description", scene_.description);
    std::string encoding;
    if (root.read("encoding", encoding)) scene_.encoding = encoding == "display" ? Encoding::Display : Encoding::Linear;
    if (const auto camera = root.object("camera")) readCamera(*camera);
    if (const auto background = root.object("background")) readBackground(*background);
    for (const auto& light : root.members("lights")) readLight(root.open("lights", light));
    scene_.materials.push_back(defaultMaterial());
    const bool named = readMaterials(root, document);
    for (const auto& object : root.members("objects")) readObject(root.open("objects", object));
    if (named) unknownMaterials_.report("material", namesIn(materials_), "define it under \"materials\"", report_);
    resolveCentres();
    refuseCircles();
    return std::move(scene_);
}

/// False where the materials as a whole are wrong, and that has been told: then nothing is known of their names.
bool SceneReader::readMaterials(const ObjectReader& root, const JsonValue& document) {
    const std::size_t before = report_.problems.count();
    const auto members = root.members("materials");
    if (members.empty() && report_.problems.count() > before) return false;
    for (const auto& material : members) readMaterial(root.open("materials", material), material.name);
    return root.has("materials") ||
           std::none_of(document.children.begin(), document.children.end(),
                        [](const JsonValue& member) { return !closest(member.key, {"materials"}).empty(); });
}

/// The view must be a view in float32, in which the shader computes it.
void SceneReader::readCamera(const ObjectReader& camera) {
    constexpr double kParallel = 1e-6; // sine of the angle between up and the view
    CameraPose& pose = scene_.camera;
    camera.read("eye", pose.eye);
    camera.read("target", pose.target);
    camera.read("up", pose.up);
    camera.read("fov", pose.fov);
    if (!camera.sound()) return;
    if (glm::vec3(pose.eye) == glm::vec3(pose.target))
        return report_.add(camera.line(), camera.path(), "eye and target are the same point", "move one of them");
    if (glm::length(glm::cross(pose.up, glm::normalize(pose.target - pose.eye))) < kParallel)
        report_.add(camera.line(), camera.path(), "up is parallel to the view from eye to target",
                    "use another direction for \"up\"");
}

void SceneReader::readBackground(const ObjectReader& background) {
    background.read("color", scene_.background.color);
    background.read("cubemap", scene_.background.cubemap);
    background.read("image", scene_.background.image);
    if (const auto gradient = background.object("gradient")) {
        Gradient& target = scene_.background.gradient.emplace();
        gradient->read("top", target.top);
        gradient->read("bottom", target.bottom);
    }
}

void SceneReader::readLight(const ObjectReader& reader) {
    Light light;
    if (const auto point = reader.object("point")) point->read("position", light.position);
    if (const auto sphere = reader.object("sphere")) {
        sphere->read("center", light.position);
        sphere->read("radius", light.radius);
    }
    reader.read("color", light.color);
    scene_.lights.push_back(light);
}

void SceneReader::readMaterial(const ObjectReader& reader, const std::string& name) {
    Material material;
    material.name = name;
    reader.read("ambient", material.ambient);
    reader.read("diffuse", material.diffuse);
    reader.read("specular", material.specular);
    reader.read("emission", material.emission);
    reader.read("shininess", material.shininess);
    readOptics(reader, material);
    material.texture = readTexture(reader, "texture");
    material.normalMap = readTexture(reader, "normal_map");
    materials_.emplace(name, int(scene_.materials.size()));
    scene_.materials.push_back(std::move(material));
}

void SceneReader::readOptics(const ObjectReader& material, Material& target) {
    if (const auto reader = material.object("conductor")) {
        Conductor conductor;
        reader->read("n", conductor.n);
        reader->read("k", conductor.k);
        target.optics = conductor;
    }
    if (const auto reader = material.object("dielectric")) {
        Dielectric dielectric;
        reader->read("ior", dielectric.ior);
        target.optics = dielectric;
    }
    if (const auto reader = material.object("coat")) {
        Coat coat;
        reader->read("ior", coat.ior);
        reader->read("mask", coat.mask);
        target.optics = coat;
    }
}

std::optional<TextureUse> SceneReader::readTexture(const ObjectReader& material, std::string_view key) {
    if (!material.has(key)) return std::nullopt;
    TextureUse use;
    if (const auto texture = material.objectOrImage(key, use.image)) {
        texture->read("image", use.image);
        texture->read("scale", use.scale);
        texture->read("scroll", use.scroll);
    }
    return use;
}

void SceneReader::readObject(const ObjectReader& reader) {
    Object object;
    object.line = reader.line();
    object.shape = readShape(reader, report_);
    readName(reader, object);
    readMaterialName(reader, object);
    reader.read("casts_shadow", object.castsShadow);
    readMotion(reader, object);
    readGlow(reader, object);
    scene_.objects.push_back(std::move(object));
}

void SceneReader::readName(const ObjectReader& object, Object& target) {
    if (!object.read("name", target.name)) return;
    const auto [first, isNew] = objects_.emplace(target.name, int(scene_.objects.size()));
    if (!isNew)
        report_.add(object.lineOf("name"), object.pathOf("name"),
                    "the name " + inQuotes(target.name) + " is taken by objects[" + std::to_string(first->second) + "]",
                    "use each name once");
}

void SceneReader::readMaterialName(const ObjectReader& object, Object& target) {
    std::string name;
    if (!object.read("material", name)) return;
    const auto found = materials_.find(name);
    if (found != materials_.end()) {
        target.material = found->second;
        return;
    }
    unknownMaterials_.add(name, object.lineOf("material"), object.pathOf("material"));
}

void SceneReader::readMotion(const ObjectReader& object, Object& target) {
    const auto motion = object.object("motion");
    const auto reader = motion ? motion->object("orbit") : std::nullopt;
    if (!reader) return;
    Orbit orbit;
    reader->read("cos", orbit.cos);
    reader->read("sin", orbit.sin);
    reader->read("rate", orbit.rate);
    target.motion = orbit;
    std::string around;
    if (reader->read("around", around))
        centres_.push_back({int(scene_.objects.size()), around, reader->lineOf("around"), reader->pathOf("around")});
}

void SceneReader::readGlow(const ObjectReader& object, Object& target) {
    const auto reader = object.object("glow");
    if (!reader) return;
    Glow glow;
    reader->read("color", glow.color);
    reader->read("strength", glow.strength);
    reader->read("softness", glow.softness);
    target.glow = glow;
    if (target.shape.kind != ShapeKind::Sphere)
        report_.add(reader->line(), reader->path(), "only spheres can glow", "remove \"glow\" or use a sphere");
}

void SceneReader::resolveCentres() {
    UnknownNames unknown;
    for (const Centre& centre : centres_) {
        const auto found = objects_.find(centre.name);
        if (found != objects_.end()) {
            scene_.objects[std::size_t(centre.object)].motion->around = found->second;
            continue;
        }
        unknown.add(centre.name, centre.line, centre.path);
    }
    unknown.report("object", namesIn(objects_), "give the object a \"name\"", report_);
}

/// Each circle is reported once, at the first of its objects that the file moves.
void SceneReader::refuseCircles() {
    enum class State : char { New, OnTheWay, Done };
    std::vector<State> states(scene_.objects.size(), State::New);
    const auto next = [&](int i) {
        const auto& motion = scene_.objects[std::size_t(i)].motion;
        return motion ? motion->around : -1;
    };
    for (const Centre& centre : centres_) {
        int i = centre.object;
        for (; i >= 0 && states[std::size_t(i)] == State::New; i = next(i)) states[std::size_t(i)] = State::OnTheWay;
        if (i >= 0 && states[std::size_t(i)] == State::OnTheWay)
            report_.add(centre.line, centre.path, inQuotes(centre.name) + " moves around itself in the end",
                        "let one object of the circle rest, or move around none");
        for (i = centre.object; i >= 0 && states[std::size_t(i)] == State::OnTheWay; i = next(i))
            states[std::size_t(i)] = State::Done;
    }
}

} // namespace

std::optional<Scene> readScene(std::string_view text, const std::string& file, Problems& problems) {
    ProblemCounter counter(file, problems);
    const std::optional<JsonValue> document = parseJson(text, counter);
    if (!document) return std::nullopt;
    Scene scene = SceneReader(counter).read(*document);
    if (counter.count() > 0) return std::nullopt;
    return scene;
}

} // namespace gnomon
