// Marches a cone within the light's: as long as it, of a relative radius below the nearest found so far, touches
// nothing, nothing is nearer but for the error allowed. A model says beforehand
//
// met       the nearest after meeting something at that relative distance while a cone of relative radius `marched` was
//           clear
// narrower  the relative radius of the cone to march next
// dark      whether no more light can be lost
//
// FROM_LIGHT  from the light to the surface, else from the surface to the light
// Steps       when they run out the nearest found so far stands: what is not reached counts as free
// Source      the source document's base algorithm, with slips of its text mended: relative distances are to the
//             light's cone, not to the one found last, and a step is taken whether or not anything came nearer
float nearestAlong(ShadowCone cone) {
    float nearest = 1.0;
    float marched = narrower(nearest);
    float t = 0.0;
    for (int i = 0; i < frame.shadowSteps; ++i) {
#if FROM_LIGHT
        float at = cone.reach - t;
#else
        float at = t;
#endif
        float radius = coneRadius(cone, at);
        float free = coneDistance(cone, at);
        if (free < nearest * radius) {
            nearest = met(free / radius, marched);
            marched = narrower(nearest);
        }
        if (dark(nearest)) break;
        t += max(free - radius * marched, 0.0) / (1.0 + abs(marched * cone.slope));
        if (t >= cone.reach) break;
    }
    return nearest;
}
