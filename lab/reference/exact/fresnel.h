/// Reflectance of unpolarised light by the Fresnel equations as they stand in textbooks, in complex numbers.
#pragma once

#include <cmath>
#include <complex>

namespace gnomon::oracle {

/// At `cosine` to the normal of a smooth surface; `index`, n + ik, is that beyond over that on the ray's side.
template<class R>
R fresnelReflectance(R cosine, std::complex<R> index) {
    const std::complex<R> square = index * index;
    const std::complex<R> root = std::sqrt(square - (1 - cosine) * (1 + cosine)); // index beyond times its cosine
    if (cosine == 0 && root == std::complex<R>(0)) return 0;                      // along a surface that is none
    const R s = std::norm((cosine - root) / (cosine + root));
    const R p = std::norm((square * cosine - root) / (square * cosine + root));
    return (s + p) / 2;
}

} // namespace gnomon::oracle
