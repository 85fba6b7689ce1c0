/// A scene's fields on the GPU: what the settings ask for is baked a little at a time, while what was baked before is
/// drawn with.
///
/// The order of use: want, then step until baked() is 1. Where there is nothing to draw with, coarse fields are baked
/// first. A lost context begins all anew.
#pragma once

#include "tracer/plan/field_layout.h"
#include "tracer/plan/prepared_scene.h"
#include "tracer/render/pass/bake_pass.h"

#include <optional>
#include <vector>

namespace gnomon {

class SceneFields {
  public:
    explicit SceneFields(PreparedScenePtr prepared) : prepared_(std::move(prepared)) {}

    /// Fields as these settings say, from here on; those that are baked so already stay. A problem where
    /// they become smaller than asked for.
    void want(const Settings&, const gl::Info&, Problems&);
    /// Bakes on. The layout of new fields where they take the place of the old: the packer needs it.
    std::optional<FieldLayout> step(ProgramCache&, const CodegenTarget&, Problems&);
    /// There are fields to draw with, coarse or old ones as well.
    bool usable() const { return bool(current_); }
    /// Fraction of the wanted fields that is baked.
    double baked() const;
    bool failed() const { return failed_; }
    void bind() const;

  private:
    /// Fields of one resolution.
    struct Stage {
        FieldLayout layout;
        Settings settings;
    };

    bool beginSlot(const CodegenTarget&, Problems&);

    PreparedScenePtr prepared_;
    std::optional<Settings> wanted_;
    std::vector<Stage> stages_; ///< to be baked, the last one first
    gl::Volume current_, next_;
    BakePass pass_;
    std::size_t slot_ = 0; ///< of the first stage, that is baked now
    bool began_ = false, failed_ = false;
    gl::Fence drawn_;
    double asked_ = 0; ///< when the last step began
    int slices_ = 1; ///< that a step takes
};

} // namespace gnomon
