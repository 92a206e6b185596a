//! Images as text, for people and tests.

use std::fmt::Write;

use crate::{Op, Program};

/// The operations of a program, one a line; those that begin an instruction line have its number before them.
#[must_use]
pub fn disassemble(program: &Program) -> String {
    let mut text = String::new();
    for (at, op) in (0u32..).zip(&program.code) {
        let line = program.lines.iter().position(|line| line.op == at);
        let number = line.map_or(String::new(), |line| (line + 1).to_string());
        // Writing to a string does not fail.
        let _ = writeln!(text, "{number:>4} {at:>5}  {}", shown(op, program));
    }
    text
}

fn shown(op: &Op, program: &Program) -> String {
    let name = |site: u32| program.instructions.get(site as usize).map_or("?", |site| site.name.as_ref());
    match op {
        Op::Instruction { site } => format!("Instruction {}", name(*site)),
        other => format!("{other:?}"),
    }
}
