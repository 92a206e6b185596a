//! The sine of an angle in degrees (manual 3.2.3), correct to the last bit or the one before.
//!
//! It is computed with any [`Real`]: numbers here, machine code elsewhere, which then has the same bits. Nothing
//! branches, as nobody can foresee the quarter of the turn that an angle is in.

use std::ops::{Add, Mul, Sub};

/// What a sine can be computed with: operations of IEEE 754, and two on bits.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// The number with the bits of [`HEAD`] alone.
    #[must_use]
    fn head(self) -> Self;

    /// For an angle near zero, given its sine and cosine, the sine so many quarters of a turn further on. The number
    /// itself, of which the lowest bits count, and `ahead` tell how many.
    #[must_use]
    fn sine_after(self, ahead: u64, sin: Self, cos: Self) -> Self;
}

impl Real for f64 {
    fn head(self) -> Self {
        Self::from_bits(self.to_bits() & HEAD)
    }

    fn sine_after(self, ahead: u64, sin: Self, cos: Self) -> Self {
        let quarters = self.to_bits().wrapping_add(ahead);
        let value = if quarters & 1 == 0 { sin } else { cos };
        Self::from_bits(value.to_bits() ^ ((quarters & 2) << 62))
    }
}

/// The bits of the larger half of a number: sign, exponent, and 26 bits with the one that is not written.
pub const HEAD: u64 = !0 << 27;

/// Below as many degrees, the quarters of a turn are a number that is exact, and exact in degrees too.
pub const MANY_TURNS: f64 = 360.0 * 2_147_483_648.0;

/// A number to which this is added is rounded, and its units are the lowest bits.
const UNITS: f64 = 6_755_399_441_055_744.0;

/// π/180 as the sum of two doubles.
const RADIANS: (f64, f64) = (0.017453292519943295, 2.9486522708701687e-19);

/// π/180, cut in two halves whose products with another half are exact.
const RADIANS_HEAD: f64 = 0.01745329238474369;
const RADIANS_TAIL: f64 = 1.3519960498364902e-10;

/// Coefficients of the powers of the sine from the third on, in radians; those of FDLIBM.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-6,
    -2.5050760253406863e-8,
    1.58969099521155e-10,
];

/// Coefficients of the powers of the cosine from the fourth on, in radians; those of FDLIBM.
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-5,
    -2.7557314351390663e-7,
    2.087572321298175e-9,
    -1.1359647557788195e-11,
];

/// The sine of an angle of less than [`MANY_TURNS`] degrees, so many quarters of a turn further on; never -0.
pub fn sine_of<N: Real>(degrees: N, ahead: u64) -> N {
    let (quarters, rest) = reduce(degrees);
    let (sin, cos) = near_zero(rest);
    quarters.sine_after(ahead, sin, cos) + 0.0
}

/// Sine and cosine of an angle of less than [`MANY_TURNS`] degrees; never -0.
pub fn sine_and_cosine<N: Real>(degrees: N) -> (N, N) {
    let (quarters, rest) = reduce(degrees);
    let (sin, cos) = near_zero(rest);
    (quarters.sine_after(0, sin, cos) + 0.0, quarters.sine_after(1, sin, cos) + 0.0)
}

/// How many quarters of a turn, in the lowest bits, lead to the direction that is nearest, and what is left of the
/// angle, exactly: at most 45°, but for what rounding does where two directions are as near.
pub(crate) fn reduce<N: Real>(degrees: N) -> (N, N) {
    let quarters = degrees * (1.0 / 90.0) + UNITS;
    (quarters, degrees - (quarters - UNITS) * 90.0)
}

/// The angle in radians, and what rounding has taken from it.
pub(crate) fn to_radians<N: Real>(degrees: N) -> (N, N) {
    let radians = degrees * RADIANS.0;
    (radians, product_error(degrees, radians) + degrees * RADIANS.1)
}

/// What `product`, the rounded product of `degrees` and π/180, lacks (T. J. Dekker).
fn product_error<N: Real>(degrees: N, product: N) -> N {
    let head = degrees.head();
    let tail = degrees - head;
    ((head * RADIANS_HEAD - product) + head * RADIANS_TAIL + tail * RADIANS_HEAD) + tail * RADIANS_TAIL
}

/// Sine and cosine of an angle of at most 45°.
fn near_zero<N: Real>(degrees: N) -> (N, N) {
    let (radians, error) = to_radians(degrees);
    let square = radians * radians;
    let half = square * 0.5;
    let up_to_square = (half - 1.0) * -1.0;
    let rest = square * (square * (square * (square * SINE[5] + SINE[4]) + SINE[3]) + SINE[2]) + SINE[1];
    let sin = radians + (square * radians * (square * rest + SINE[0]) + error * up_to_square);
    let rest = square * (square * (square * (square * COSINE[5] + COSINE[4]) + COSINE[3]) + COSINE[2]) + COSINE[1];
    let lost = (up_to_square - 1.0 + half) * -1.0;
    let cos = up_to_square + (lost + (square * square * (square * rest + COSINE[0]) - radians * error));
    (sin, cos)
}
