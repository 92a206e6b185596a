//! Quotients and remainders.

use val3_bytecode::Register;

use crate::body::Body;
use crate::lanes::Lane;
use crate::local;

impl Body<'_> {
    /// To divide by a power of two is to multiply with its inverse, to the last bit.
    pub(crate) fn divide(&mut self, to: Register, a: Register, b: Register) {
        match self.study.lanes.get(b) {
            Lane::Constant(divisor) if is_power_of_two(divisor) => self.set(to, |body| {
                body.get(a);
                body.code().f64_const((1.0 / divisor).into()).f64_mul();
            }),
            Lane::Constant(divisor) if divisor != 0.0 => self.quotient(to, a, b),
            _ => {
                self.is_zero(b);
                self.when(Self::leave_it);
                self.quotient(to, a, b);
            }
        }
    }

    /// The remainder by a whole number: that of the whole part, and the fraction, which is exact. Others, and those of
    /// numbers that are no `i32`, are left to the interpreter.
    pub(crate) fn remainder(&mut self, to: Register, a: Register, b: Register) {
        match self.study.lanes.get(b) {
            Lane::Constant(divisor) if is_whole(divisor) && divisor != 0.0 => {
                if self.study.whole.has(a) {
                    self.whole_remainder_by(to, a, divisor.abs());
                } else {
                    self.remainder_by(to, a, divisor.abs());
                }
            }
            _ => self.remainder_of(to, a, b),
        }
    }

    /// The remainder by a constant, without a division: half a unit more than the whole part, times the inverse, lies
    /// between the quotient and the next, far from both where neither number has more than 31 bits.
    fn remainder_by(&mut self, to: Register, a: Register, divisor: f64) {
        self.get(a);
        self.code().f64_abs().local_tee(local::B).f64_trunc().local_tee(local::A);
        self.code().f64_const(f64::from(i32::MAX).into()).f64_le();
        self.unless(Self::leave_it);
        self.set(to, |body| {
            body.left_by(divisor);
            body.code().local_get(local::B).local_get(local::A).f64_sub().f64_add();
            body.get(a);
            body.code().f64_copysign();
        });
    }

    /// The same where there is no fraction.
    fn whole_remainder_by(&mut self, to: Register, a: Register, divisor: f64) {
        self.get(a);
        self.code().f64_abs().local_tee(local::A).f64_const(f64::from(i32::MAX).into()).f64_le();
        self.unless(Self::leave_it);
        self.set(to, |body| {
            body.left_by(divisor);
            body.get(a);
            body.code().f64_copysign();
        });
    }

    /// What is left of the whole number in a variable.
    fn left_by(&mut self, divisor: f64) {
        self.code().local_get(local::A);
        self.code().local_get(local::A).f64_const(0.5.into()).f64_add().f64_const((1.0 / divisor).into()).f64_mul();
        self.code().f64_trunc().f64_const(divisor.into()).f64_mul().f64_sub();
    }

    /// The remainder by a number that is known when it is computed. The one by -1 may leave the range.
    fn remainder_of(&mut self, to: Register, a: Register, b: Register) {
        self.get(b);
        self.code().i32_trunc_sat_f64_s().local_tee(local::J).f64_convert_i32_s();
        self.get(b);
        self.code().f64_ne();
        // 0 and -1.
        self.code().local_get(local::J).i32_const(1).i32_add().i32_const(2).i32_lt_u().i32_or();
        self.when(Self::leave_it);
        self.get(a);
        self.code().i32_trunc_sat_f64_s().local_tee(local::I).f64_convert_i32_s().local_tee(local::A);
        self.get(a);
        self.code().f64_trunc().f64_ne();
        self.when(Self::leave_it);
        self.set(to, |body| {
            body.code().local_get(local::I).local_get(local::J).i32_rem_s().f64_convert_i32_s();
            body.get(a);
            body.code().local_get(local::A).f64_sub().f64_add().f64_abs();
            body.get(a);
            body.code().f64_copysign();
        });
    }

    fn quotient(&mut self, to: Register, a: Register, b: Register) {
        self.set(to, |body| {
            body.get(a);
            body.get(b);
            body.code().f64_div();
        });
    }

    fn is_zero(&mut self, register: Register) {
        self.get(register);
        self.code().f64_const(0.0.into()).f64_eq();
    }
}

/// An `i32`.
fn is_whole(number: f64) -> bool {
    number.trunc() == number && number.abs() <= f64::from(i32::MAX)
}

/// A number whose inverse is exact.
fn is_power_of_two(number: f64) -> bool {
    const FRACTION: u64 = (1 << 52) - 1;
    number.to_bits() & FRACTION == 0 && number.is_normal() && (1.0 / number).is_normal()
}

#[cfg(test)]
mod tests {
    use super::{is_power_of_two, is_whole};

    #[test]
    fn numbers_with_an_exact_inverse() {
        for number in [1.0, 2.0, -2.0, 0.5, 1024.0, f64::MIN_POSITIVE * 4.0] {
            assert!(is_power_of_two(number), "{number}");
        }
        for number in [0.0, -0.0, 3.0, 0.1, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE / 2.0, f64::MAX] {
            assert!(!is_power_of_two(number), "{number}");
        }
    }

    #[test]
    fn whole_numbers() {
        assert!([0.0, 3.0, -3.0, 2_147_483_647.0].into_iter().all(is_whole));
        assert!(![0.5, 2_147_483_648.0, f64::NAN, f64::NEG_INFINITY].into_iter().any(is_whole));
    }
}
