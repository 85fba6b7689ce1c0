/// A scene's images on the GPU: paints, normals and the sky. Grey, flat and night stand in until they come.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/plan/scene_packer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

/// What the host has given so far.
struct Pictures {
    std::map<std::string, Image> images; ///< by name: kept, so that a new context can be filled again
    bool once = false;                   ///< no context will: the texels are dropped once they are on the GPU
};

class SceneImages {
  public:
    /// Images larger than `maxSide` are drawn smaller.
    SceneImages(PreparedScenePtr, int maxSide);

    /// A picture has come, or another in its place: what shows it is uploaded anew.
    void arrived(const std::string& name);
    /// Fraction of the scene's images that are among the pictures.
    double fraction(const Pictures&) const;

    /// Uploads what is not there as it should be, and binds all. Answers the tiles that paints and normals take where
    /// they are new. A problem where images are drawn smaller than they are.
    std::optional<Tiles> bind(Pictures&, Problems&);

  private:
    struct LayerSizes {
        std::vector<glm::ivec2> paints, normals; ///< of the images alone
    };

    /// That the GL may be given.
    struct Most {
        std::size_t paintBytes, normalBytes; ///< of the finest levels
        int skySide;
    };

    LayerSizes layerSizes(const Pictures&) const;
    std::size_t peakMemory(const Pictures&, const LayerSizes&) const;
    Most most(const Pictures&, Problems&) const;
    gl::Texture upload(const std::vector<glm::ivec2>& sizes, const gl::ImageSource&, gl::Texels, std::size_t bytes,
                       std::vector<glm::vec2>& tiles, Problems&) const;
    Tiles uploadLayers(Pictures&, const Most&, Problems&);
    void uploadCubemap(Pictures&, int side, Problems&);
    void uploadPanorama(Pictures&, int side, Problems&);
    Image taken(Pictures&, const std::string& name, const Image& standIn);
    void tellTooWide(glm::ivec2 size, Problems&) const;
    void tellReduced(const std::string& why, Problems&) const;
    gl::Texels coding() const;

    PreparedScenePtr prepared_;
    int maxSide_;
    std::map<std::string, int> uses_; ///< of each image, in layers and sky, that are not uploaded yet
    gl::Texture paints_, normals_, sky_;
    bool layersStale_ = true, skyStale_ = true;
};

} // namespace gnomon
