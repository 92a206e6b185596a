//! Instructions that compute a number from one to three numbers and have no other effect. They do not require a
//! [`Call`], so the interpreter can compute them directly.
//!
//! [`Call`]: crate::call::Call

use val3_geometry::degrees;

use crate::fault::{Fault, Result};
use crate::instruction::{ArgumentForm, Instruction, Overload};
use crate::runtime_errors::INVALID_NUMBER;
use crate::types::BaseType;
use crate::values::{bits, numbers};
use crate::versions::Version;

/// Computes the instruction. Missing arguments may have any value.
type Compute = fn([f64; 3]) -> Result<f64>;

macro_rules! number_functions {
    ($($function:ident $name:literal = $compute:expr;)+) => {
        /// An instruction that computes a number from numbers or truth values.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub enum NumberFunction {
            $(#[doc = concat!("`", $name, "`")] $function,)+
        }

        /// All functions, ordered by number.
        const ALL: &[(NumberFunction, &str, Compute)] = &[$((NumberFunction::$function, $name, $compute)),+];
    };
}

number_functions! {
    Abs "abs" = |[a, ..]| Ok(numbers::abs(a));
    Acos "acos" = |[a, ..]| degrees::acos(a).ok_or(Fault(INVALID_NUMBER));
    And "bAnd" = |[a, b, _]| Ok(bits::and(a, b));
    Asin "asin" = |[a, ..]| degrees::asin(a).ok_or(Fault(INVALID_NUMBER));
    Atan "atan" = |[a, ..]| Ok(degrees::atan(a));
    Cos "cos" = |[a, ..]| Ok(degrees::cos(a));
    Exp "exp" = |[a, ..]| numbers::exp(a);
    Limit "limit" = |[a, b, c]| Ok(numbers::limit(a, b, c));
    Ln "ln" = |[a, ..]| numbers::ln(a);
    Log "log" = |[a, ..]| numbers::log(a);
    Max "max" = |[a, b, _]| Ok(numbers::max(a, b));
    Min "min" = |[a, b, _]| Ok(numbers::min(a, b));
    Not "bNot" = |[a, ..]| Ok(bits::not(a));
    Or "bOr" = |[a, b, _]| Ok(bits::or(a, b));
    Power "power" = |[a, b, _]| numbers::power(a, b);
    SignedPower "power" = |[a, b, _]| numbers::signed_power(a, b);
    Round "round" = |[a, ..]| Ok(numbers::round(a));
    RoundDown "roundDown" = |[a, ..]| Ok(numbers::round_down(a));
    RoundUp "roundUp" = |[a, ..]| Ok(numbers::round_up(a));
    Sel "sel" = |[a, b, c]| Ok(numbers::sel(a != 0.0, b, c));
    Sin "sin" = |[a, ..]| Ok(degrees::sin(a));
    Sqrt "sqrt" = |[a, ..]| numbers::sqrt(a);
    Tan "tan" = |[a, ..]| Ok(degrees::tan(a));
    Xor "bXor" = |[a, b, _]| Ok(bits::xor(a, b));
}

impl NumberFunction {
    /// Function for an instruction form in a version; `None` if it does not compute a number only from numbers.
    #[must_use]
    pub fn of(instruction: &Instruction, form: &Overload, version: Version) -> Option<Self> {
        let takes_numbers = form.params.iter().all(|param| param.shape == ArgumentForm::Value && is_number(param.ty));
        let (function, ..) = ALL.iter().find(|(_, name, _)| *name == instruction.name)?;
        let function = match function {
            Self::Power if version.raises_negative_numbers() => Self::SignedPower,
            function => *function,
        };
        (takes_numbers && is_number(form.result)).then_some(function)
    }

    /// Number of the function.
    #[must_use]
    pub fn number(self) -> u32 {
        self as u32
    }

    /// Finds the function with this number.
    #[must_use]
    pub fn numbered(number: u32) -> Option<Self> {
        ALL.get(number as usize).map(|(function, ..)| *function)
    }

    /// Computes the result. The arguments come first; further values are ignored.
    ///
    /// # Errors
    /// The errors of the instruction.
    #[inline]
    pub fn compute(self, arguments: [f64; 3]) -> Result<f64> {
        let (.., compute) = ALL.get(self as usize).ok_or(Fault::INTERPRETER)?;
        compute(arguments)
    }
}

fn is_number(ty: Option<BaseType>) -> bool {
    matches!(ty, Some(BaseType::Num | BaseType::Bool))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Bench;
    use crate::values::number_text::significant;

    const NUMBERS: [f64; 8] = [0.0, 1.0, -1.0, 0.5, -2.5, 90.0, 1e10, -360.25];

    #[test]
    fn numbers_are_converted_both_ways() {
        for (at, (function, ..)) in (0u32..).zip(ALL) {
            assert_eq!((function.number(), NumberFunction::numbered(at)), (at, Some(*function)));
        }
        assert_eq!(NumberFunction::numbered(u32::MAX), None);
    }

    #[test]
    fn each_computes_what_its_instruction_does() {
        let versions = [Version::DEFAULT, Version::new(8, 0, 0)];
        for ((function, name, _), version) in ALL.iter().flat_map(|row| versions.map(|version| (row, version))) {
            let instruction = crate::instructions::find(name).unwrap();
            let mut forms = instruction.overloads.iter();
            let form = forms.find(|form| NumberFunction::of(instruction, form, version) == Some(*function));
            let Some(params) = form.map(|form| form.params) else {
                assert!(matches!(function, NumberFunction::Power | NumberFunction::SignedPower), "{name}");
                continue;
            };
            for (a, b, c) in NUMBERS.iter().flat_map(|a| NUMBERS.map(|b| (*a, b, 7.0))) {
                let arguments = [a, b, c].into_iter().zip(params).map(|(value, param)| match param.ty {
                    Some(BaseType::Bool) => (value != 0.0).to_string(),
                    _ => value.to_string(),
                });
                let call = format!("{name}({})", arguments.collect::<Vec<_>>().join(","));
                let expected = function.compute([a, b, c]);
                let expected =
                    expected.map_or_else(|fault| format!("error {}", fault.0), |value| significant(value).to_string());
                let mut bench = Bench::default();
                bench.version = version;
                assert_eq!(bench.run(&call), expected, "{call}");
            }
        }
    }

    #[test]
    fn other_forms_are_no_functions() {
        for (name, functions) in [("abs", 1), ("sqrt", 1), ("clock", 0), ("len", 0)] {
            let instruction = crate::instructions::find(name).unwrap();
            let of = |form| NumberFunction::of(instruction, form, Version::DEFAULT);
            assert_eq!(instruction.overloads.iter().filter_map(of).count(), functions, "{name}");
        }
    }
}
