#include "native/file/asset_folder.h"

#include "native/file/input_file.h"
#include "tracer/scene/json_document.h"
#include "tracer/scene/read_scene.h"

#include <algorithm>
#include <cstdlib>

namespace gnomon {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostImageBytes = std::size_t(128) << 20; ///< of a file: no picture within the limits needs more

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

bool isFolder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// Is `text` a path rather than a scene's name?
bool looksLikeFile(const std::string& text) {
    return text.find('/') != std::string::npos || fs::path(text).extension() == ".json";
}

} // namespace

std::optional<AssetFolder> AssetFolder::find(Problems& problems) {
    if (const char* chosen = std::getenv("GNOMON_ASSETS"); chosen && *chosen) {
        if (isFolder(fs::path(chosen) / "scenes")) return AssetFolder(chosen);
        problems.push_back({"GNOMON_ASSETS",
                            0,
                            {},
                            std::string(chosen) + " holds no folder scenes",
                            "let it name the assets folder, or unset it"});
        return std::nullopt;
    }
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const fs::path& root : {program.parent_path() / "share" / "gnomon", fs::path(GNOMON_SOURCE_DIR) / "assets"})
        if (isFolder(root / "scenes")) return AssetFolder(root);
    problems.push_back({{},
                        0,
                        {},
                        "the scenes and textures that come with the program are not found",
                        "set GNOMON_ASSETS to the assets folder"});
    return std::nullopt;
}

std::vector<std::string> AssetFolder::sceneNames() const {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(root_ / "scenes", ignored)) {
        const fs::path name = entry.path().filename();
        // `NAME.schema.json` describes scenes; it is none.
        if (name.extension() == ".json" && name.stem().extension().empty()) names.push_back(name.stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::optional<fs::path> AssetFolder::fileOf(const std::string& nameOrFile, Problems& problems) const {
    if (!looksLikeFile(nameOrFile)) {
        const fs::path named = root_ / "scenes" / (nameOrFile + ".json");
        if (isFile(named)) return named;
    }
    std::error_code ignored;
    if (nameOrFile == "-" || (fs::exists(nameOrFile, ignored) && !isFolder(nameOrFile))) return nameOrFile;
    if (isFolder(nameOrFile)) {
        problems.push_back({nameOrFile, 0, {}, "is a folder", "name a scene file in it"});
        return std::nullopt;
    }
    const auto names = sceneNames();
    const auto meant = closest(nameOrFile, {names.begin(), names.end()});
    std::string remedy = "`gnomon scenes` lists the names";
    if (!meant.empty()) remedy = "did you mean '" + std::string(meant) + "'?";
    if (looksLikeFile(nameOrFile))
        problems.push_back(
            {nameOrFile, 0, {}, "there is no such scene file", meant.empty() ? "check the path" : remedy});
    else
        problems.push_back({{}, 0, {}, "there is no scene '" + nameOrFile + "'", remedy});
    return std::nullopt;
}

std::optional<Scene> AssetFolder::readScene(const std::string& nameOrFile, Problems& problems) const {
    const auto file = fileOf(nameOrFile, problems);
    if (!file) return std::nullopt;
    const auto text = readInput(file->string(), kMaxJsonBytes, "use a smaller scene", problems);
    return text ? gnomon::readScene(*text, inputName(file->string()), problems) : std::nullopt;
}

std::optional<Image> AssetFolder::readImage(const Scene& scene, const std::string& name, Problems& problems) const {
    // Beside the scene; one that came through a pipe stands in the folder that the program was started in.
    const fs::path folder = isFile(scene.file) ? fs::path(scene.file).parent_path() : fs::path();
    std::vector<fs::path> places{folder / (name + ".png"), root_ / "textures" / (name + ".png")};
    for (const auto& place : places) {
        if (!isFile(place)) continue;
        const auto bytes = readInput(place.string(), kMostImageBytes, "use a smaller image", problems);
        if (!bytes) return std::nullopt;
        return decodeImage(place.string(), {reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()},
                           problems);
    }
    problems.push_back({scene.file,
                        0,
                        {},
                        "image '" + name + "' is missing",
                        "put it at " + places[0].string() + " or " + places[1].string()});
    return std::nullopt;
}

std::optional<NamedImages> AssetFolder::readImages(const Scene& scene, Problems& problems) const {
    NamedImages images;
    const auto names = imagesOf(scene);
    for (const auto& name : names)
        if (auto image = readImage(scene, name, problems)) images.emplace_back(name, std::move(*image));
    return images.size() == names.size() ? std::optional(std::move(images)) : std::nullopt;
}

std::optional<Loaded> load(const std::string& nameOrFile, Problems& problems) {
    const auto assets = AssetFolder::find(problems);
    if (!assets) return std::nullopt;
    auto scene = assets->readScene(nameOrFile, problems);
    if (!scene) return std::nullopt;
    auto images = assets->readImages(*scene, problems);
    if (!images) return std::nullopt;
    return Loaded{*assets, std::move(*scene), std::move(*images)};
}

} // namespace gnomon
