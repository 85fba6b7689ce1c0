/// Reads the objects of a scene file: groups and instances are taken apart, meshes become triangles.
#pragma once

#include "tracer/scene/affine.h"
#include "tracer/scene/object_names.h"
#include "tracer/scene/read_scene.h"

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gnomon {

class ObjectsReader {
  public:
    /// `files` gives meshes and surfaces.
    ObjectsReader(const ObjectReader& root, const std::vector<Material>& materials,
                  const std::map<std::string, int>& materialNames, const SceneFiles&, SceneReport&);

    /// All that is drawn, in the order of the file.
    std::vector<Object> read();
    void reportUnknownMaterials() const;

  private:
    /// What is read into: the scene, or a definition.
    struct Target {
        std::vector<Object> objects;
        ObjectNames names;
    };
    enum class ModelKind : char { FlatMesh, SmoothMesh, Surface };
    using Model = std::pair<std::string, ModelKind>; ///< a file, and as what
    struct Definition {
        ObjectReader::Member member;
        enum class State : char { New, BeingRead, Read } state = State::New;
        std::vector<Object> objects;
    };

    void readObject(const ObjectReader&, Target&);
    void readGroup(const ObjectReader&, Target&);
    void readInstance(const ObjectReader&, Target&);
    void readMesh(const ObjectReader&, Target&);
    void readModel(const ObjectReader&, ModelKind, Target&);
    std::variant<std::vector<Shape>, Complaint> modelOf(const Model&) const;
    void readDefinition(Definition&);
    void place(const ObjectReader& group, std::size_t from, Target&);
    void readMaterial(const ObjectReader&, std::size_t from, Target&);
    void readMotion(const ObjectReader&, std::size_t from, Target&);
    void readGlow(const ObjectReader&, std::size_t from, Target&);
    bool hasRoom(std::size_t more, const ObjectReader&, const Target&);

    const ObjectReader& root_;
    const std::vector<Material>& materials_;
    const std::map<std::string, int>& materialNames_;
    const SceneFiles& files_;
    SceneReport& report_;
    std::map<std::string, Definition> definitions_;
    bool knowsDefinitions_ = false; ///< all that the file names
    std::map<Model, std::vector<Shape>> models_;
    UnknownNames unknownMaterials_, unknownDefinitions_;
    std::size_t made_ = 0; ///< objects, those of definitions as well
    bool full_ = false;
};

} // namespace gnomon
