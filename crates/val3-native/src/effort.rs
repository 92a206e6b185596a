//! How long machine code takes, roughly: from time to time others outside have to look.

use val3_bytecode::{Op, Program};
use val3_lang::number_functions::NumberFunction;

/// What takes a tenth of a second, or less.
const MOST: u64 = 100_000_000;

/// The lines that a stretch may execute in programs like these, in which steps are as frequent as in their text.
pub(crate) fn most_lines<'p>(programs: impl Iterator<Item = &'p Program>) -> u32 {
    let steps = programs.flat_map(|program| &program.code);
    let (lines, effort) =
        steps.fold((1, 1), |(lines, all), step| (lines + u64::from(step.line), all + effort(step.op)));
    u32::try_from(MOST * lines / effort).unwrap_or(u32::MAX)
}

/// How long an operation takes, against the addition of two numbers.
fn effort(op: Op) -> u64 {
    match op {
        Op::Divide { .. } | Op::Remainder { .. } | Op::Call { .. } => 5,
        Op::Function { function, .. } => match function {
            NumberFunction::Sin | NumberFunction::Cos => 20,
            NumberFunction::Abs | NumberFunction::Min | NumberFunction::Max | NumberFunction::Sel => 1,
            _ => 50,
        },
        _ => 1,
    }
}
