/// What to draw, and how: scene, settings and target become one plan, the plan becomes shader source and packed scene
/// data. Pure: the same three give the same plan.
#pragma once

#include "tracer/plan/codegen_target.h"
#include "tracer/plan/prepared_scene.h"
#include "tracer/plan/scene_features.h"
#include "tracer/plan/screen_split.h"

#include <string>

namespace gnomon {

struct Plan {
    SceneFeatures scene;
    CodegenTarget target;
    ScreenSplit split;

    bool operator==(const Plan&) const = default;
};

/// Objects of it are parametric surfaces, of which fields may be baked.
bool hasSurfaces(const Scene&);

/// For one variant, the full one. `settings.data` Auto takes a block where that holds the scene and is as fast.
Plan planOf(const PreparedScene&, const Settings&, const CodegenTarget&);

/// No plan tells the two apart: only settings differ that are uniforms or the host's.
bool planAlike(const Settings&, const Settings&);
/// Fields that are baked by the two are the same.
bool bakesAlike(const Settings&, const Settings&);

/// The plan without what no source depends on. Where it is equal for two plans, so is their source.
Plan sourceKeyOf(Plan);

/// What in the plan contradicts itself; empty where nothing does.
std::string contradictionIn(const Plan&);

} // namespace gnomon
