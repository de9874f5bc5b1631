#include "halfspace/fft.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.hpp"

namespace wrc::halfspace {
namespace {

// One butterfly of `radix` inputs over `count` contiguous numbers: in[r] += twiddle products, out[r] in
// order. Stockham's self-sorting scheme: reads are `in_step` apart, writes `out_step` apart, no bit reversal.
struct Pass {
  const double* in_re;
  const double* in_im;
  double* out_re;
  double* out_im;
  std::size_t in_step, out_step, count;
  const double* cos;
  const double* sin;
};

void radix2(const Pass& s) {
  // sum; difference times exp(-i theta)
  const double c = s.cos[0], d = s.sin[0];
  for (std::size_t q = 0; q < s.count; ++q) {
    const double ar = s.in_re[q], ai = s.in_im[q];
    const double br = s.in_re[q + s.in_step], bi = s.in_im[q + s.in_step];
    s.out_re[q] = ar + br;
    s.out_im[q] = ai + bi;
    const double er = ar - br, ei = ai - bi;
    s.out_re[q + s.out_step] = er * c + ei * d;
    s.out_im[q + s.out_step] = ei * c - er * d;
  }
}

void radix4(const Pass& s) {
  const double c1 = s.cos[0], d1 = s.sin[0], c2 = s.cos[1], d2 = s.sin[1], c3 = s.cos[2], d3 = s.sin[2];
  const double *r0 = s.in_re, *r1 = r0 + s.in_step, *r2 = r1 + s.in_step, *r3 = r2 + s.in_step;
  const double *i0 = s.in_im, *i1 = i0 + s.in_step, *i2 = i1 + s.in_step, *i3 = i2 + s.in_step;
  double* __restrict wr0 = s.out_re, * __restrict wi0 = s.out_im;
  double* __restrict wr1 = wr0 + s.out_step, * __restrict wi1 = wi0 + s.out_step;
  double* __restrict wr2 = wr1 + s.out_step, * __restrict wi2 = wi1 + s.out_step;
  double* __restrict wr3 = wr2 + s.out_step, * __restrict wi3 = wi2 + s.out_step;
  for (std::size_t q = 0; q < s.count; ++q) {
    // sums and differences of opposite inputs; a quarter turn is an exchange of parts
    const double sr = r0[q] + r2[q], si = i0[q] + i2[q], dr = r0[q] - r2[q], di = i0[q] - i2[q];
    const double tr = r1[q] + r3[q], ti = i1[q] + i3[q], er = r1[q] - r3[q], ei = i1[q] - i3[q];
    wr0[q] = sr + tr;
    wi0[q] = si + ti;
    // times the twiddles exp(-i theta) of the outputs 1 to 3
    const double x1 = dr + ei, y1 = di - er, x2 = sr - tr, y2 = si - ti, x3 = dr - ei, y3 = di + er;
    wr1[q] = x1 * c1 + y1 * d1;
    wi1[q] = y1 * c1 - x1 * d1;
    wr2[q] = x2 * c2 + y2 * d2;
    wi2[q] = y2 * c2 - x2 * d2;
    wr3[q] = x3 * c3 + y3 * d3;
    wi3[q] = y3 * c3 - x3 * d3;
  }
}

void radix3(const Pass& s) {
  // sine of a third of a turn; its cosine is -1/2
  const double h = std::sqrt(0.75);
  for (std::size_t q = 0; q < s.count; ++q) {
    const double ar = s.in_re[q], ai = s.in_im[q];
    const double br = s.in_re[q + s.in_step], bi = s.in_im[q + s.in_step];
    const double cr = s.in_re[q + 2 * s.in_step], ci = s.in_im[q + 2 * s.in_step];
    const double tr = br + cr, ti = bi + ci, ur = h * (bi - ci), ui = h * (cr - br);
    const double mr = ar - 0.5 * tr, mi = ai - 0.5 * ti;
    s.out_re[q] = ar + tr;
    s.out_im[q] = ai + ti;
    const double x1 = mr + ur, y1 = mi + ui, x2 = mr - ur, y2 = mi - ui;
    s.out_re[q + s.out_step] = x1 * s.cos[0] + y1 * s.sin[0];
    s.out_im[q + s.out_step] = y1 * s.cos[0] - x1 * s.sin[0];
    s.out_re[q + 2 * s.out_step] = x2 * s.cos[1] + y2 * s.sin[1];
    s.out_im[q + 2 * s.out_step] = y2 * s.cos[1] - x2 * s.sin[1];
  }
}

void radix5(const Pass& s) {
  // cosine and sine of 2 pi / 5 and 4 pi / 5
  constexpr double c1 = 0.30901699437494742410, c2 = -0.80901699437494742410;
  constexpr double s1 = 0.95105651629515357212, s2 = 0.58778525229247312917;
  for (std::size_t q = 0; q < s.count; ++q) {
    double r[5], i[5];
    for (std::size_t k = 0; k < 5; ++k) {
      r[k] = s.in_re[q + k * s.in_step];
      i[k] = s.in_im[q + k * s.in_step];
    }
    // pairs that are mirror images: their sums see cosines, their differences sines
    const double p1r = r[1] + r[4], p1i = i[1] + i[4], m1r = r[1] - r[4], m1i = i[1] - i[4];
    const double p2r = r[2] + r[3], p2i = i[2] + i[3], m2r = r[2] - r[3], m2i = i[2] - i[3];
    const double er = r[0] + c1 * p1r + c2 * p2r, ei = i[0] + c1 * p1i + c2 * p2i;
    const double fr = r[0] + c2 * p1r + c1 * p2r, fi = i[0] + c2 * p1i + c1 * p2i;
    const double gr = s1 * m1i + s2 * m2i, gi = -(s1 * m1r + s2 * m2r);
    const double hr = s2 * m1i - s1 * m2i, hi = -(s2 * m1r - s1 * m2r);
    const double xr[5] = {r[0] + p1r + p2r, er + gr, fr + hr, fr - hr, er - gr};
    const double xi[5] = {i[0] + p1i + p2i, ei + gi, fi + hi, fi - hi, ei - gi};
    s.out_re[q] = xr[0];
    s.out_im[q] = xi[0];
    for (std::size_t k = 1; k < 5; ++k) {
      s.out_re[q + k * s.out_step] = xr[k] * s.cos[k - 1] + xi[k] * s.sin[k - 1];
      s.out_im[q + k * s.out_step] = xi[k] * s.cos[k - 1] - xr[k] * s.sin[k - 1];
    }
  }
}

// Sine and cosine of 2 pi k / n, 0 <= k < n: of the angle within its quarter turn, in whole numbers, and that
// many quarters.
SineCosine root_of_unity(int k, int n) {
  // angle = quarters * pi/2 + rest, 0 <= rest < pi/2: exact but for the rest's own rounding
  const int quarters = 4 * k / n;
  const SineCosine rest = sine_cosine(0.5 * pi * (4 * k - quarters * n) / n);
  switch (quarters) {
    case 0:
      return rest;
    case 1:
      return {rest.cosine, -rest.sine};
    case 2:
      return {-rest.sine, -rest.cosine};
    default:
      return {-rest.cosine, rest.sine};
  }
}

}  // namespace

int Fft::good_length(int minimum) {
  for (int n = std::max(minimum, 1);; ++n) {
    // a product of 2, 3 and 5 alone leaves 1
    int rest = n;
    for (int prime : {2, 3, 5}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return n;
  }
}

Fft::Fft(int length) : length_(length) {
  int rest = length;
  while (rest > 1) {
    // fours first: they take the least arithmetic per point
    const int radix = rest % 4 == 0 ? 4 : rest % 2 == 0 ? 2 : rest % 3 == 0 ? 3 : 5;
    Stage stage{.radix = radix, .blocks = rest / radix, .cos = {}, .sin = {}};
    for (int p = 0; p < stage.blocks; ++p) {
      // twiddles exp(-2 pi i p r / rest) of block p
      for (int r = 1; r < radix; ++r) {
        const SineCosine root = root_of_unity(p * r, rest);
        stage.cos.push_back(root.cosine);
        stage.sin.push_back(root.sine);
      }
    }
    stages_.push_back(std::move(stage));
    rest = stages_.back().blocks;
  }
}

void Fft::forward(double* re, double* im, double* work_re, double* work_im, int signals) const {
  double *a_re = re, *a_im = im, *b_re = work_re, *b_im = work_im;
  std::size_t stride = static_cast<std::size_t>(signals);
  for (const Stage& stage : stages_) {
    // inputs of a butterfly lie a block's length apart, outputs beside each other: Stockham's order needs no
    // reversal
    const auto radix = static_cast<std::size_t>(stage.radix), blocks = static_cast<std::size_t>(stage.blocks);
    for (std::size_t p = 0; p < blocks; ++p) {
      const Pass pass{a_re + stride * p,
                      a_im + stride * p,
                      b_re + stride * radix * p,
                      b_im + stride * radix * p,
                      stride * blocks,
                      stride,
                      stride,
                      stage.cos.data() + p * (radix - 1),
                      stage.sin.data() + p * (radix - 1)};
      switch (stage.radix) {
        case 2:
          radix2(pass);
          break;
        case 3:
          radix3(pass);
          break;
        case 4:
          radix4(pass);
          break;
        default:
          radix5(pass);
      }
    }
    std::swap(a_re, b_re);
    std::swap(a_im, b_im);
    stride *= radix;
  }
  // an odd number of stages ends in the work arrays
  if (a_re != re) {
    std::copy_n(a_re, stride, re);
    std::copy_n(a_im, stride, im);
  }
}

// The backward transform is the forward one with real and imaginary parts exchanged on the way in and out.
void Fft::backward(double* re, double* im, double* work_re, double* work_im, int signals) const {
  forward(im, re, work_im, work_re, signals);
}

void transpose(const double* in, double* out, int rows, int columns) {
  // tiles of a cache line each way
  constexpr int tile = 8;
  for (int i0 = 0; i0 < rows; i0 += tile) {
    for (int j0 = 0; j0 < columns; j0 += tile) {
      for (int i = i0; i < std::min(i0 + tile, rows); ++i) {
        for (int j = j0; j < std::min(j0 + tile, columns); ++j) {
          out[static_cast<std::size_t>(j) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(i)] =
              in[static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(j)];
        }
      }
    }
  }
}

void backward_2d(const Fft& along_x, const Fft& along_y, int rows, const Plane& p) {
  const int length = along_x.length();
  // along y, turned round, along x for the rows wanted
  along_y.backward(p.re.data(), p.im.data(), p.work_re.data(), p.work_im.data(), length);
  transpose(p.re.data(), p.work_re.data(), rows, length);
  transpose(p.im.data(), p.work_im.data(), rows, length);
  p.re.swap(p.work_re);
  p.im.swap(p.work_im);
  along_x.backward(p.re.data(), p.im.data(), p.work_re.data(), p.work_im.data(), rows);
}

}  // namespace wrc::halfspace
