// Hard shadow: 1 where nothing lies between the point and the light, else 0. Any hit ends the search, and what lies behind
// the light is no occluder.
float visibility(Ray toLight, float distance) { return occluded(toLight, distance) ? 0.0 : 1.0; }
