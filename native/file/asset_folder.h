/// Scenes and textures: those that come with the program, by name, and the user's own, by file.
#pragma once

#include "tracer/image.h"
#include "tracer/problem.h"
#include "tracer/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gnomon {

using NamedImages = std::vector<std::pair<std::string, Image>>;

class AssetFolder {
  public:
    /// $GNOMON_ASSETS, else ../share/gnomon beside the program, else the source tree it was built from.
    static std::optional<AssetFolder> find(Problems&);
    explicit AssetFolder(std::filesystem::path root) : root_(std::move(root)) {}

    const std::filesystem::path& root() const { return root_; }
    /// Names of the scenes that come with the program, sorted.
    std::vector<std::string> sceneNames() const;
    /// The scene called `nameOrFile`, else the file of that path, checked.
    std::optional<Scene> readScene(const std::string& nameOrFile, Problems&) const;
    /// Every image the scene needs. With a problem for each that is missing or broken, and then nothing; more than
    /// 512 MB together are refused before one is decoded. Notes tell what files say that is not followed.
    std::optional<NamedImages> readImages(const Scene&, Problems&, Problems* notes = nullptr) const;

  private:
    std::optional<std::filesystem::path> fileOf(const std::string& nameOrFile, Problems&) const;
    std::optional<std::filesystem::path> imageFileOf(const Scene&, const std::string& name, Problems&) const;

    std::filesystem::path root_;
};

/// All that is drawn from, read and checked.
struct Loaded {
    AssetFolder assets;
    Scene scene;
    NamedImages images;
    Problems notes; ///< what is to be told, and hinders nothing
};
/// As AssetFolder::find, readScene and readImages have it.
std::optional<Loaded> load(const std::string& nameOrFile, Problems&);

} // namespace gnomon
