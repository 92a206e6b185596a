//! Ranges of numbers.

use std::ops::{Bound, RangeBounds};

use crate::types::Container;
use crate::values::numbers::round;
use crate::versions::Version;

use Bound::{Excluded, Included, Unbounded};

/// Valid numbers for an argument.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArgumentRange {
    /// Minimum.
    pub low: Bound<f64>,
    /// Maximum.
    pub high: Bound<f64>,
    /// Effect of a number outside of the range.
    pub beyond: OutOfRange,
    /// Whether the instruction rounds the number before it compares it with the bounds.
    pub is_rounded: bool,
}

/// Effect of a number outside of the range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutOfRange {
    /// The task stops with this run-time error.
    Fails(u16),
    /// The instruction has another effect, described in a few words: "the column is taken modulo 40".
    Instead(&'static str),
}

impl ArgumentRange {
    /// Whether the number is valid.
    #[must_use]
    pub fn takes(&self, number: f64) -> bool {
        let number = if self.is_rounded { round(number) } else { number };
        (self.low, self.high).contains(&number)
    }

    /// The same range for an instruction that rounds the number first.
    const fn rounded(self) -> Self {
        Self { is_rounded: true, ..self }
    }
}

/// Range of the parameter `parameter` of `instruction`; `None` if all numbers are valid.
#[must_use]
pub fn range(instruction: &str, parameter: &str) -> Option<&'static ArgumentRange> {
    let mut rows = RANGES.iter();
    let (_, _, range) = rows.find(|(known, of, _)| *known == instruction && *of == parameter)?;
    Some(range)
}

/// Parameter that names an array dimension.
pub const DIMENSION: &str = "nDimension";

/// Dimensions of a container; `None` for a container without dimensions.
#[must_use]
pub fn dimensions(container: Container) -> Option<&'static ArgumentRange> {
    match container {
        Container::Array { dims } => DIMENSIONS.get(usize::from(dims).checked_sub(1)?),
        Container::Element | Container::Collection => None,
    }
}

/// Range of the bases that `power` can raise to `exponent`; `None` if `base` is valid without a range, or if `exponent`
/// is `None` (unknown).
///
/// Up to s7, the base must be positive. From s8 on, a negative base is valid with a whole exponent, and 0 with a
/// positive exponent.
#[must_use]
pub fn power_base(version: Version, base: f64, exponent: Option<f64>) -> Option<&'static ArgumentRange> {
    if !version.raises_negative_numbers() {
        return Some(&POSITIVE);
    }
    let exponent = exponent?;
    let is_whole = exponent.fract() == 0.0;
    match (base < 0.0 && is_whole, exponent > 0.0) {
        (true, _) => None,
        (false, true) => Some(&NOT_NEGATIVE),
        (false, false) => Some(&POSITIVE),
    }
}

/// Exclusive upper bound of the numbers that `count` outputs can represent in binary (3.5.3).
#[must_use]
pub fn bits(count: u32) -> f64 {
    f64::from(count).exp2()
}

/// Whether the parameter is a time in seconds (5.10).
#[must_use]
pub fn counts_seconds(parameter: &str) -> bool {
    parameter == "nSeconds"
}

const INVALID_NUMBER: OutOfRange = OutOfRange::Fails(11);
const INVALID_PARAMETER: OutOfRange = OutOfRange::Fails(70);
/// Range of bit fields: whole numbers of 32 bits (3.3.1).
const BIT_FIELD: ArgumentRange =
    between(Included(0.0), Included(4_294_967_295.0), OutOfRange::Instead(BIT_FIELD_ROUNDING)).rounded();
const BIT_FIELD_ROUNDING: &str = "the number is forced into a bit field of 32 bits";
const NO_WAIT: OutOfRange = OutOfRange::Instead("the task does not wait");
const COLUMN: ArgumentRange =
    between(Included(0.0), Included(39.0), OutOfRange::Instead("the column is taken modulo 40")).rounded();
const LINE: ArgumentRange =
    between(Included(0.0), Included(13.0), OutOfRange::Instead("the line is taken modulo 14")).rounded();
const COUNT: ArgumentRange = between(Included(0.0), Unbounded, INVALID_PARAMETER).rounded();
const SINE: ArgumentRange = between(Included(-1.0), Included(1.0), INVALID_NUMBER);
const NOT_NEGATIVE: ArgumentRange = between(Included(0.0), Unbounded, INVALID_NUMBER);
const POSITIVE: ArgumentRange = between(Excluded(0.0), Unbounded, INVALID_NUMBER);
const PART_OF_PATH: ArgumentRange = between(Excluded(-1.0), Excluded(2.0), INVALID_PARAMETER);
const FORCE: ArgumentRange = between(Included(-1000.0), Included(1000.0), INVALID_PARAMETER);

/// Valid dimensions, by the number of dimensions.
static DIMENSIONS: [ArgumentRange; 3] = [
    between(Included(1.0), Included(1.0), INVALID_PARAMETER).rounded(),
    between(Included(1.0), Included(2.0), INVALID_PARAMETER).rounded(),
    between(Included(1.0), Included(3.0), INVALID_PARAMETER).rounded(),
];

const fn between(low: Bound<f64>, high: Bound<f64>, beyond: OutOfRange) -> ArgumentRange {
    ArgumentRange { low, high, beyond, is_rounded: false }
}

/// Instruction, parameter and range, in the order of the manual's sections.
#[rustfmt::skip]
static RANGES: [(&str, &str, ArgumentRange); 43] = [
    ("size", DIMENSION, between(Included(1.0), Included(3.0), OutOfRange::Instead("the result is 0")).rounded()),
    ("resize", DIMENSION, between(Included(1.0), Included(3.0), INVALID_PARAMETER).rounded()),
    ("resize", "nSize", between(Included(1.0), Unbounded, INVALID_PARAMETER).rounded()),
    ("asin", "nValue", SINE),
    ("acos", "nValue", SINE),
    ("sqrt", "nValue", NOT_NEGATIVE),
    ("exp", "nValue", between(Unbounded, Excluded(709.8), INVALID_NUMBER)),
    ("power", "nX", POSITIVE),
    ("ln", "nValue", POSITIVE),
    ("log", "nValue", POSITIVE),
    ("bNot", "nBitField", BIT_FIELD),
    ("bAnd", "nBitField1", BIT_FIELD),
    ("bAnd", "nBitField2", BIT_FIELD),
    ("bOr", "nBitField1", BIT_FIELD),
    ("bOr", "nBitField2", BIT_FIELD),
    ("bXor", "nBitField1", BIT_FIELD),
    ("bXor", "nBitField2", BIT_FIELD),
    ("toBinary", "nValueSize", COUNT),
    ("fromBinary", "nDataSize", COUNT),
    ("chr", "nCodePoint", between(Included(0.0), Included(1_114_111.0), OutOfRange::Instead("the result is an empty string")).rounded()),
    ("asc", "nPosition", between(Included(0.0), Included(127.0), OutOfRange::Instead("the result is -1")).rounded()),
    ("left", "nSize", COUNT),
    ("right", "nSize", COUNT),
    ("mid", "nSize", COUNT),
    ("mid", "nPosition", COUNT),
    ("insert", "nPosition", COUNT),
    ("delete", "nSize", COUNT),
    ("delete", "nPosition", COUNT),
    ("replace", "nSize", COUNT),
    ("replace", "nPosition", COUNT),
    ("dioSet", "nValue", between(Included(0.0), Unbounded, OutOfRange::Instead("a negative number has no pattern of bits"))),
    ("gotoxy", "nX", COLUMN),
    ("gotoxy", "nY", LINE),
    ("setTextMode", "nMode", between(Included(0.0), Included(3.0), INVALID_PARAMETER)),
    ("taskCreate", "nPriority", between(Included(1.0), Included(100.0), INVALID_PARAMETER).rounded()),
    ("taskCreateSync", "nPeriod", between(Excluded(0.0), Unbounded, INVALID_PARAMETER)),
    ("delay", "nSeconds", between(Included(0.0), Unbounded, NO_WAIT)),
    ("watch", "nSeconds", between(Included(0.0), Unbounded, NO_WAIT)),
    ("setMonitorSpeed", "nSpeed", between(Included(0.0), Included(100.0), OutOfRange::Instead("nothing changes and the result is -3"))),
    ("interpolateL", "nPosition", PART_OF_PATH),
    ("interpolateC", "nPosition", PART_OF_PATH),
    ("movejf", "nForce", FORCE),
    ("movelf", "nForce", FORCE),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::instructions;

    #[test]
    fn rows_name_parameters_of_the_catalogue() {
        for (name, parameter, range) in &RANGES {
            let instruction = instructions::find(name).unwrap();
            let mut params = instruction.overloads.iter().flat_map(|form| form.params);
            assert!(params.any(|param| param.name == *parameter), "{name} {parameter}");
            if let OutOfRange::Fails(number) = range.beyond {
                assert!(instruction.errors.contains(&number), "{name} {number}");
            }
        }
    }

    #[test]
    fn bounds_are_included_or_excluded() {
        let force = range("movejf", "nForce").unwrap();
        assert!(force.takes(1000.0) && !force.takes(1000.1));
        let part = range("interpolateL", "nPosition").unwrap();
        assert!(part.takes(1.99) && !part.takes(2.0) && !part.takes(-1.0));
        assert_eq!(part.beyond, OutOfRange::Fails(70));
    }

    #[test]
    fn numbers_of_things_are_rounded() {
        for (instruction, parameter, low) in
            [("resize", "nSize", 1.0), ("left", "nSize", 0.0), ("size", DIMENSION, 1.0)]
        {
            let range = range(instruction, parameter).unwrap();
            assert!(range.takes(low - 0.3) && range.takes(low - 0.5) && !range.takes(low - 0.6), "{instruction}");
        }
        let mode = range("setTextMode", "nMode").unwrap();
        assert!(!mode.takes(3.2), "the text mode is not rounded");
    }

    #[test]
    fn the_domain_of_power_depends_on_the_version() {
        assert!(takes(7, 2.0, Some(-3.0)) && !takes(7, -2.0, Some(2.0)) && !takes(7, 0.0, None));
        for (base, exponent) in [(-2.0, 2.0), (-2.0, -3.0), (0.0, 0.5), (2.0, 0.5), (-2.0, 0.0)] {
            assert!(takes(8, base, Some(exponent)), "{base} to {exponent}");
        }
        for (base, exponent) in [(-2.0, 0.5), (-2.0, -0.5), (0.0, 0.0), (0.0, -1.0)] {
            assert!(!takes(8, base, Some(exponent)), "{base} to {exponent}");
        }
        assert!(takes(8, -2.0, None));
    }

    /// Whether `power` accepts the base with this exponent in a version.
    fn takes(major: u8, base: f64, exponent: Option<f64>) -> bool {
        power_base(Version::new(major, 0, 0), base, exponent).is_none_or(|range| range.takes(base))
    }

    #[test]
    fn parameters_without_limits_have_no_range() {
        assert_eq!(range("sin", "nAngle"), None);
    }

    #[test]
    fn four_outputs_show_sixteen_numbers() {
        assert!((bits(4) - 16.0).abs() < f64::EPSILON);
    }
}
