#include "native/file/asset_folder.h"

#include "native/file/input_file.h"
#include "tracer/png.h"
#include "tracer/scene/json_document.h"
#include "tracer/scene/read_scene.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <span>

namespace gnomon {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFileBytes = std::size_t(128) << 20;    ///< of an image
constexpr std::size_t kMostDecodedBytes = std::size_t(512) << 20; ///< of all images of a scene together

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

bool isFolder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

/// Memory that an image file's pixels take, as it says itself; 0 of a file that says nothing.
std::uint64_t decodedBytes(const fs::path& file) {
    std::array<char, kPngHeaderBytes> bytes{};
    std::ifstream(file, std::ios::binary).read(bytes.data(), bytes.size());
    const auto header = pngHeader({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    return header ? header->pixels() * 4 : 0;
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
    if (!text) return std::nullopt;
    const fs::path folder = isFile(*file) ? file->parent_path() : fs::path();
    const auto beside = [&](const std::string& path, Problems& missing) {
        return readInput((folder / path).string(), kMaxSceneFileBytes, "use a smaller file", missing);
    };
    return gnomon::readScene(*text, inputName(file->string()), problems, beside);
}

std::optional<fs::path> AssetFolder::imageFileOf(const Scene& scene, const std::string& name,
                                                 Problems& problems) const {
    // Beside the scene; one that came through a pipe stands in the folder that the program was started in.
    const fs::path folder = isFile(scene.file) ? fs::path(scene.file).parent_path() : fs::path();
    for (const auto& place : {folder / name, root_ / "textures" / name})
        for (const char* ending : {".png", ".PNG"})
            if (const fs::path file = place.string() + ending; isFile(file)) return file;
    problems.push_back(
        {scene.file,
         0,
         {},
         "image '" + name + "' is missing",
         "put it at " + (folder / name).string() + ".png or " + (root_ / "textures" / name).string() + ".png"});
    return std::nullopt;
}

std::optional<NamedImages> AssetFolder::readImages(const Scene& scene, Problems& problems) const {
    const std::size_t before = problems.size();
    std::vector<std::pair<std::string, fs::path>> files;
    std::uint64_t decoded = 0;
    for (const auto& name : imagesOf(scene))
        if (const auto file = imageFileOf(scene, name, problems)) {
            files.emplace_back(name, *file);
            decoded += decodedBytes(*file);
        }
    if (decoded > kMostDecodedBytes)
        problems.push_back({scene.file,
                            0,
                            {},
                            "its images take " + std::to_string(decoded >> 20) + " MB; 512 MB are the most",
                            "use fewer or smaller images"});
    NamedImages images;
    for (const auto& [name, file] : files) {
        if (decoded > kMostDecodedBytes) break;
        const auto bytes = readInput(file.string(), kMostFileBytes, "use a smaller image", problems);
        if (!bytes) continue;
        const std::span span(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
        if (auto image = decodeImage(file.string(), span, problems)) images.emplace_back(name, std::move(*image));
    }
    return problems.size() == before ? std::optional(std::move(images)) : std::nullopt;
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
