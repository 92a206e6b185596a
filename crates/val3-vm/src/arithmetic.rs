//! What operations compute that takes more than an expression.

use val3_bytecode::Register;
use val3_lang::fault::{Fault, Result};
use val3_lang::runtime_errors::DIVISION_BY_ZERO;
use val3_lang::values::Text;

/// `to = a + b`, in place where that can be.
pub(crate) fn concatenate(texts: &mut [Text], to: Register, (a, b): (Register, Register)) -> Result<()> {
    let [to, a, b] = [to, a, b].map(usize::from);
    if let Ok([text, right]) = texts.get_disjoint_mut([to, b])
        && to == a
    {
        *text += right;
        return Ok(());
    }
    let (left, right) = texts.get(a).zip(texts.get(b)).ok_or(Fault::INTERPRETER)?;
    let sum = *left + right;
    *texts.get_mut(to).ok_or(Fault::INTERPRETER)? = sum;
    Ok(())
}

/// A truth value as a number.
#[inline]
pub(crate) fn truth(value: bool) -> f64 {
    f64::from(u8::from(value))
}

/// The remainder has the sign of the left side (3.2.2).
pub(crate) fn remainder(a: f64, b: f64) -> Result<f64> {
    if b == 0.0 { Err(Fault(DIVISION_BY_ZERO)) } else { Ok(a % b) }
}

/// The counter of a `for` has passed its limit (2.2.5).
#[inline]
pub(crate) fn is_beyond(counter: f64, limit: f64, step: f64) -> bool {
    if step < 0.0 { counter < limit } else { counter > limit }
}
