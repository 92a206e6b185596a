//! Constant arguments outside the parameter's range.

use std::fmt::{self, Display};
use std::ops::Bound;

use val3_analysis::body::ExprId;
use val3_lang::arguments::{ArgumentRange, DIMENSION, dimensions, power_base, range};
use val3_lang::instructions::{POWER, RESIZE};
use val3_lang::values::printed::num;

use super::{Call, ProgramView};

/// A constant number that its instruction does not accept.
pub(crate) struct OutOfRange {
    pub(crate) argument: ExprId,
    pub(crate) callee: &'static str,
    pub(crate) parameter: &'static str,
    pub(crate) value: f64,
    pub(crate) range: &'static ArgumentRange,
}

impl OutOfRange {
    /// Message: one sentence.
    pub(crate) fn message(&self) -> String {
        let Self { callee, parameter, value, range, .. } = self;
        format!("`{callee}` takes {} for `{parameter}`, not {}", RangeInWords(range), num(*value))
    }
}

/// All constant arguments that are out of range.
pub(crate) fn out_of_range(program: &ProgramView<'_>) -> Vec<OutOfRange> {
    let mut found = Vec::new();
    for call in program.calls() {
        let callee = call.instruction.name;
        for (param, argument) in call.arguments() {
            let Some(value) = program.body.number(argument) else { continue };
            let range = program.range_of(call, param.name).filter(|range| !range.takes(value));
            let Some(range) = range else { continue };
            found.push(OutOfRange { argument, callee, parameter: param.name, value, range });
        }
    }
    found
}

impl ProgramView<'_> {
    /// Range of a parameter. It may depend on the version and on the other arguments.
    fn range_of(&self, call: &Call<'_>, parameter: &str) -> Option<&'static ArgumentRange> {
        let range = range(call.instruction.name, parameter)?;
        match (call.instruction.name, parameter, call.args) {
            (POWER, _, [base, exponent]) => {
                power_base(self.items.version, self.body.number(*base)?, self.body.number(*exponent))
            }
            (RESIZE, DIMENSION, [array, dimension, _]) if range.takes(self.body.number(*dimension)?) => {
                dimensions(self.inference.ty(*array).container)
            }
            _ => Some(range),
        }
    }
}

/// Formats a range in words: "1 to 100", "more than 0", "at least 0".
pub(crate) struct RangeInWords<'r>(pub(crate) &'r ArgumentRange);

impl Display for RangeInWords<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let low = match self.0.low {
            Bound::Included(low) => Some(format!("at least {low}")),
            Bound::Excluded(low) => Some(format!("more than {low}")),
            Bound::Unbounded => None,
        };
        let high = match self.0.high {
            Bound::Included(high) => Some(format!("at most {high}")),
            Bound::Excluded(high) => Some(format!("less than {high}")),
            Bound::Unbounded => None,
        };
        match (self.0.low, self.0.high) {
            (Bound::Included(low), Bound::Included(high)) if low >= high => write!(f, "{low}"),
            (Bound::Included(low), Bound::Included(high)) => write!(f, "{low} to {high}"),
            _ => f.write_str(&low.into_iter().chain(high).collect::<Vec<_>>().join(" and ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_written_in_words() {
        let spoken = |name, parameter| RangeInWords(range(name, parameter).unwrap()).to_string();
        assert_eq!(spoken("setTextMode", "nMode"), "0 to 3");
        assert_eq!(spoken("ln", "nValue"), "more than 0");
        assert_eq!(spoken("sqrt", "nValue"), "at least 0");
        assert_eq!(spoken("exp", "nValue"), "less than 709.8");
        assert_eq!(spoken("interpolateL", "nPosition"), "more than -1 and less than 2");
    }
}
