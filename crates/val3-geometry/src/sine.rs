//! Sine of an angle in degrees (manual 3.2.3), with an error of at most one in the last bit.
//!
//! `libm` expects radians. Rounding to radians would lose the exact values (`sin(180)` is 0, `sin(30)` is 0.5) and the
//! last bit of other results. The quarter turn is selected without a branch, because a branch would be unpredictable.

/// Mask for the upper half of a number: sign, exponent, and 26 bits including the implicit one.
const HEAD: u64 = !0 << 27;

/// Angle in degrees below which the number of quarter turns is exact, and so is its product with 90.
pub(crate) const MANY_TURNS: f64 = 360.0 * 2_147_483_648.0;

/// Adding this number rounds a number to an integer, which is then in the lowest bits.
const UNITS: f64 = 6_755_399_441_055_744.0;

/// π/180 as the sum of two doubles.
const RADIANS: (f64, f64) = (0.017453292519943295, 2.9486522708701687e-19);

/// π/180, split into two halves whose products with another half are exact.
const RADIANS_HEAD: f64 = 0.01745329238474369;
const RADIANS_TAIL: f64 = 1.3519960498364902e-10;

/// Coefficients of the sine from the third power on, in radians, as in FDLIBM.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-6,
    -2.5050760253406863e-8,
    1.58969099521155e-10,
];

/// Coefficients of the cosine from the fourth power on, in radians, as in FDLIBM.
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-5,
    -2.7557314351390663e-7,
    2.087572321298175e-9,
    -1.1359647557788195e-11,
];

/// Returns the sine of the angle plus `ahead` quarter turns; never -0. The angle is in degrees, below [`MANY_TURNS`].
pub(crate) fn sine_of(degrees: f64, ahead: u64) -> f64 {
    let (quarters, rest) = reduce(degrees);
    let (sin, cos) = near_zero(rest);
    sine_after(quarters, ahead, sin, cos) + 0.0
}

/// Returns sine and cosine of the angle; never -0. The angle is in degrees, below [`MANY_TURNS`].
pub(crate) fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let (quarters, rest) = reduce(degrees);
    let (sin, cos) = near_zero(rest);
    (sine_after(quarters, 0, sin, cos) + 0.0, sine_after(quarters, 1, sin, cos) + 0.0)
}

/// Returns the sine of the angle plus quarter turns, from its sine and cosine. The quarter turns are `ahead` plus the
/// number in the lowest bits of `quarters`, which `reduce` removed.
fn sine_after(quarters: f64, ahead: u64, sin: f64, cos: f64) -> f64 {
    let quarters = quarters.to_bits().wrapping_add(ahead);
    let value = if quarters & 1 == 0 { sin } else { cos };
    f64::from_bits(value.to_bits() ^ ((quarters & 2) << 62))
}

/// Returns the number of quarter turns in the lowest bits, and exactly the remaining angle: at most 45°, except for
/// rounding if two directions are equally near.
pub(crate) fn reduce(degrees: f64) -> (f64, f64) {
    let quarters = degrees * (1.0 / 90.0) + UNITS;
    (quarters, degrees - (quarters - UNITS) * 90.0)
}

/// Returns the angle in radians, and the rounding error.
pub(crate) fn to_radians(degrees: f64) -> (f64, f64) {
    let radians = degrees * RADIANS.0;
    (radians, product_error(degrees, radians) + degrees * RADIANS.1)
}

/// Returns the rounding error of `product`, the rounded product of `degrees` and π/180 (T. J. Dekker).
fn product_error(degrees: f64, product: f64) -> f64 {
    let head = f64::from_bits(degrees.to_bits() & HEAD);
    let tail = degrees - head;
    ((head * RADIANS_HEAD - product) + head * RADIANS_TAIL + tail * RADIANS_HEAD) + tail * RADIANS_TAIL
}

/// Returns sine and cosine of the angle, which is at most 45°.
fn near_zero(degrees: f64) -> (f64, f64) {
    let (radians, error) = to_radians(degrees);
    let square = radians * radians;
    let half = square * 0.5;
    let up_to_square = 1.0 - half;
    let rest = square * (square * (square * (square * SINE[5] + SINE[4]) + SINE[3]) + SINE[2]) + SINE[1];
    let sin = radians + (square * radians * (square * rest + SINE[0]) + error * up_to_square);
    let rest = square * (square * (square * (square * COSINE[5] + COSINE[4]) + COSINE[3]) + COSINE[2]) + COSINE[1];
    let lost = -(up_to_square - 1.0 + half);
    let cos = up_to_square + (lost + (square * square * (square * rest + COSINE[0]) - radians * error));
    (sin, cos)
}
