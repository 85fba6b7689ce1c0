// Sets of small numbers as the bits of one; GLSL ES 3.00 has no findLSB().
//
// lowestBit  the least number in a set that is not empty
int lowestBit(uint set) { return int(floatBitsToUint(float(set & (~set + 1u))) >> 23) - 127; } // the exponent of 2^n
