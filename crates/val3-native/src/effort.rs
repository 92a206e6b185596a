//! How long machine code takes, roughly: from time to time others outside have to look.

use val3_bytecode::{Op, Step};
use val3_lang::number_functions::NumberFunction;

/// What takes a tenth of a second, or less.
const MOST: u64 = 300_000_000;

/// The lines that a stretch may execute of programs with these steps, if each of them is as frequent as the others.
pub(crate) fn most_lines<'p>(steps: impl Iterator<Item = &'p Step>) -> u32 {
    let (lines, effort) =
        steps.fold((1, 1), |(lines, all), step| (lines + u64::from(step.line), all + effort(step.op)));
    u32::try_from(MOST * lines / effort).unwrap_or(u32::MAX)
}

/// How long an operation takes, against the addition of two numbers.
fn effort(op: Op) -> u64 {
    match op {
        Op::Call { .. } => 8,
        Op::Divide { .. } => 15,
        Op::Remainder { .. } => 30,
        Op::Function { function, .. } => match function {
            NumberFunction::Sin | NumberFunction::Cos => 30,
            NumberFunction::Abs | NumberFunction::Min | NumberFunction::Max | NumberFunction::Sel => 1,
            _ => 180,
        },
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_take_long_are_fewer() {
        let line = |op| Step { op, line: true };
        let short = [line(Op::Negate { to: 0, a: 1 })];
        let long = [line(Op::Function { function: NumberFunction::Power, to: 0, a: 1, b: 2, c: 2 })];
        assert!(most_lines(short.iter()) >= 100_000_000);
        assert!((1_000_000..5_000_000).contains(&most_lines(long.iter())));
        assert!(most_lines([].iter()) > 0);
    }
}
