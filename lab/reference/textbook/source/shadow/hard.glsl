// Hard shadow by the nearest hit on the way to the light, whose distance is compared only when all objects are asked.
float visibility(Ray toLight, float distance) {
    HitRecord hit;
    return findClosest(toLight, true, hit) && hit.t < distance ? 0.0 : 1.0;
}
