// How many distances were evaluated for this pixel: the output `steps`. The distance to the whole scene counts one, and
// so does that to a single object.
int evaluations = 0;
