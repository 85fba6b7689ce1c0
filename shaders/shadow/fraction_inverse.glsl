// The r at which fractionOf(r) = fraction, by bisection: fixed point and Newton iterations both fail at the ends, where
// the slope is 0. Error 2^-20.
float fractionInverse(float fraction) {
    if (fraction <= 0.0) return -1.0;
    if (fraction >= 1.0) return 1.0;
    float low = -1.0;
    float high = 1.0;
    for (int i = 0; i < 20; ++i) {
        float middle = 0.5 * (low + high);
        if (fractionOf(middle) < fraction) low = middle;
        else high = middle;
    }
    return 0.5 * (low + high);
}
