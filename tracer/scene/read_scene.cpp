#include "tracer/scene/read_scene.h"

#include "tracer/scene/object_reader.h"
#include "tracer/scene/read_objects.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gnomon {

namespace {

/// Reads the parts of one file into a scene. What a single value may be stands in the format tables; here stands what
/// the parts mean together.
class SceneReader {
  public:
    SceneReader(ProblemCounter& problems, const SceneFiles& files) : report_{problems}, files_(files) {
        scene_.file = problems.file();
    }

    Scene read(const JsonValue& document);

  private:
    bool readMaterials(const ObjectReader& root);
    void readCamera(const ObjectReader&);
    void readBackground(const ObjectReader&);
    void readLight(const ObjectReader&);
    void readMaterial(const ObjectReader&, const std::string& name);
    void readOptics(const ObjectReader&, Material&);
    std::optional<TextureUse> readTexture(const ObjectReader&, std::string_view key);

    SceneReport report_;
    const SceneFiles& files_;
    Scene scene_;
    std::map<std::string, int> materials_; ///< by name
};

std::string stem(const std::string& file) {
    const std::size_t slash = file.find_last_of("/\\");
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    return name.substr(0, name.rfind('.'));
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
    std::string fresnel;
    if (root.read("fresnel", fresnel)) scene_.fresnel = fresnel == "schlick" ? Fresnel::Schlick : Fresnel::Exact;
    std::string limit;
    if (root.read("depth_limit", limit)) scene_.depthLimit = limit == "dark" ? DepthLimit::Dark : DepthLimit::Straight;
    if (const auto camera = root.object("camera")) readCamera(*camera);
    if (const auto background = root.object("background")) readBackground(*background);
    for (const auto& light : root.members("lights")) readLight(root.open("lights", light));
    scene_.materials.push_back(defaultMaterial());
    const bool named = readMaterials(root);
    ObjectsReader objects(root, scene_.materials, materials_, files_, report_);
    scene_.objects = objects.read();
    if (named) objects.reportUnknownMaterials();
    return std::move(scene_);
}

/// Whether all their names are known then.
bool SceneReader::readMaterials(const ObjectReader& root) {
    const auto members = root.members("materials");
    for (const auto& material : members) readMaterial(root.open("materials", material), material.name);
    return root.readsAllOf("materials", members);
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
    if (const auto directional = reader.object("directional")) {
        light.kind = LightKind::Directional;
        directional->read("direction", light.direction);
    }
    if (const auto spot = reader.object("spot")) {
        light.kind = LightKind::Spot;
        spot->read("position", light.position);
        spot->read("direction", light.direction);
        spot->read("angle", light.angle);
        spot->read("softness", light.softness);
    }
    reader.read("color", light.color);
    reader.read("falloff", light.falloff);
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
    if (const auto squares = reader.object("checker")) {
        Checker& checker = material.checker.emplace();
        squares->read("colors", checker.colors);
        squares->read("scale", checker.scale);
    }
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
        reader->read("absorption", dielectric.absorption);
        reader->read("priority", dielectric.priority);
        target.optics = dielectric;
    }
    if (const auto reader = material.object("coat")) {
        Coat coat;
        reader->read("ior", coat.ior);
        reader->read("mask", coat.mask);
        target.optics = coat;
    }
    Mirror mirror;
    if (material.read("mirror", mirror.reflectance)) target.optics = mirror;
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

void collectFiles(const JsonValue& value, std::vector<std::string>& files) {
    for (const char* key : {"mesh", "surface"}) {
        const JsonValue* model = value.kind == JsonValue::Kind::Object ? value.find(key) : nullptr;
        const JsonValue* file = model && model->kind == JsonValue::Kind::Object ? model->find("file") : nullptr;
        if (file && std::find(files.begin(), files.end(), file->text) == files.end()) files.push_back(file->text);
    }
    for (const JsonValue& child : value.children) collectFiles(child, files);
}

} // namespace

std::optional<Scene> readScene(std::string_view text, const std::string& file, Problems& problems,
                               const SceneFiles& files) {
    ProblemCounter counter(file, problems);
    const std::optional<JsonValue> document = parseJson(text, counter);
    if (!document) return std::nullopt;
    Scene scene = SceneReader(counter, files).read(*document);
    if (counter.count() > 0) return std::nullopt;
    return scene;
}

std::vector<std::string> filesOf(std::string_view text) {
    Problems ignored;
    std::vector<std::string> files;
    if (const auto document = parseJson(text, "", ignored)) collectFiles(*document, files);
    return files;
}

} // namespace gnomon
