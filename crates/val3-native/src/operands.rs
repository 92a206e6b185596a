//! What machine code can do.

use val3_bytecode::{Op, Register, Whole};

/// The numbers of the frame that machine code reads or writes for an operation; none where it has no code for it.
pub(crate) fn registers(op: Op) -> impl Iterator<Item = Register> {
    let used: [Option<Register>; 4] = match op {
        Op::JumpUnless { condition, .. } | Op::JumpIf { condition, .. } | Op::WaitUntil { condition, .. } => {
            [Some(condition), None, None, None]
        }
        Op::IfLess { a, b, .. }
        | Op::IfLessEqual { a, b, .. }
        | Op::UnlessLess { a, b, .. }
        | Op::UnlessLessEqual { a, b, .. }
        | Op::UnlessEqual { a, b, .. }
        | Op::IfEqual { a, b, .. } => [Some(a), Some(b), None, None],
        Op::Move { to, from } => [Some(to), Some(from), None, None],
        Op::Negate { to, a } | Op::Not { to, a } => [Some(to), Some(a), None, None],
        Op::Add { to, a, b }
        | Op::Subtract { to, a, b }
        | Op::Multiply { to, a, b }
        | Op::Divide { to, a, b }
        | Op::Remainder { to, a, b }
        | Op::Less { to, a, b }
        | Op::LessEqual { to, a, b }
        | Op::Equal { to, a, b }
        | Op::NotEqual { to, a, b } => [Some(to), Some(a), Some(b), None],
        Op::Function { to, a, b, c, .. } => [Some(to), Some(a), Some(b), Some(c)],
        Op::LoadFirst { to, .. } | Op::Load { to, .. } => [Some(to), None, None, None],
        Op::StoreFirst { from, .. } | Op::Store { from, .. } => [Some(from), None, None, None],
        Op::Locate { index, .. } => [Some(index), None, None, None],
        Op::Locate2 { i, j, .. } => [Some(i), Some(j), None, None],
        Op::LoadElement { to, index, .. } => [Some(to), Some(index), None, None],
        Op::StoreElement { index, from, .. } => [Some(from), Some(index), None, None],
        Op::LoadElement2 { to, i, j, .. } => [Some(to), Some(i), Some(j), None],
        Op::StoreElement2 { from, i, j, .. } => [Some(from), Some(i), Some(j), None],
        Op::ForTest { counter, limit, .. }
        | Op::ForNext { counter, limit, .. }
        | Op::ForNextUp { counter, limit, .. } => [Some(counter), Some(limit), Some(limit + 1), None],
        _ => [None; 4],
    };
    used.into_iter().flatten()
}

/// The container in which an operation reads or writes a number, or looks one up.
pub(crate) fn container(op: Op) -> Option<Whole> {
    match op {
        Op::LoadFirst { whole, .. }
        | Op::StoreFirst { whole, .. }
        | Op::LoadElement { whole, .. }
        | Op::StoreElement { whole, .. }
        | Op::LoadElement2 { whole, .. }
        | Op::StoreElement2 { whole, .. } => Some(whole),
        _ => located(op).map(|(_, whole)| whole),
    }
}

/// The place that an operation makes by looking up a value, and the container of that.
pub(crate) fn located(op: Op) -> Option<(Register, Whole)> {
    match op {
        Op::LocateFirst { to, whole } | Op::Locate { to, whole, .. } | Op::Locate2 { to, whole, .. } => {
            Some((to, whole))
        }
        _ => None,
    }
}

/// The register that machine code writes for an operation.
pub(crate) fn written(op: Op) -> Option<Register> {
    match op {
        Op::Move { to, .. }
        | Op::Negate { to, .. }
        | Op::Not { to, .. }
        | Op::Add { to, .. }
        | Op::Subtract { to, .. }
        | Op::Multiply { to, .. }
        | Op::Divide { to, .. }
        | Op::Remainder { to, .. }
        | Op::Less { to, .. }
        | Op::LessEqual { to, .. }
        | Op::Equal { to, .. }
        | Op::NotEqual { to, .. }
        | Op::Function { to, .. }
        | Op::LoadFirst { to, .. }
        | Op::Load { to, .. }
        | Op::LoadElement { to, .. }
        | Op::LoadElement2 { to, .. }
        | Op::ForNext { counter: to, .. }
        | Op::ForNextUp { counter: to, .. } => Some(to),
        _ => None,
    }
}

/// The indexes of an operation.
pub(crate) fn index(op: Op) -> impl Iterator<Item = Register> {
    let indexes = match op {
        Op::LoadElement { index, .. } | Op::StoreElement { index, .. } | Op::Locate { index, .. } => {
            [Some(index), None]
        }
        Op::LoadElement2 { i, j, .. } | Op::StoreElement2 { i, j, .. } | Op::Locate2 { i, j, .. } => [Some(i), Some(j)],
        _ => [None; 2],
    };
    indexes.into_iter().flatten()
}
