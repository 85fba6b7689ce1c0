// Hard shadow of the light's centre: 1 where nothing lies between the point and it, else 0. Any hit ends the search.
// Pictures need no function: their rays run in the tree's own search (integrator/shadow_rays.glsl).
float visibility(ShadowQuery query) { return occluded(query.ray, query.distance - query.ray.tMin) ? 0.0 : 1.0; }
