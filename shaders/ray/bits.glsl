// Sets of small numbers as the bits of one; GLSL ES 3.00 has neither findLSB() nor findMSB().
//
// lowestBit   the least number in a set that is not empty
// highestBit  the greatest number in one; of at most 24 bits
int highestBit(uint set) { return int(floatBitsToUint(float(set)) >> 23) - 127; } // the exponent of 2^n
int lowestBit(uint set) { return highestBit(set & (~set + 1u)); }
