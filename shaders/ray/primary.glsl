// The ray from the eye through the centre of the pixel.
Ray primaryRay() {
    vec2 at = 2.0 * gl_FragCoord.xy / frame.canvas - 1.0;
    vec3 direction = normalize(frame.forward.xyz + at.x * frame.right.xyz + at.y * frame.up.xyz);
    return Ray(frame.eye.xyz, direction, 0.0, -1, 0.0);
}
