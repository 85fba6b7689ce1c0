/// A scene's images on the GPU: paints, normals and the sky. Grey, flat and night stand in until they come.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/plan/scene_packer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

/// What the host has given so far, by name: kept, so that a new context can be filled again.
using Pictures = std::map<std::string, Image>;

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
    std::optional<Tiles> bind(const Pictures&, Problems&);

  private:
    gl::Texture upload(std::vector<Image>, gl::Texels, std::vector<glm::vec2>& tiles, Problems&) const;
    Tiles uploadLayers(const Pictures&, Problems&);
    void uploadSky(const Pictures&);
    gl::Texels coding() const;

    PreparedScenePtr prepared_;
    int maxSide_;
    gl::Texture paints_, normals_, sky_;
    bool layersStale_ = true, skyStale_ = true;
};

} // namespace gnomon
