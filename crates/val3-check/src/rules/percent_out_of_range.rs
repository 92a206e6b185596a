//! V0245: a speed or acceleration in per cent that no arm has.

use val3_lang::motion::AXIS_SPEED;
use val3_lang::runtime_errors::BAD_VEL;
use val3_lang::values::HIGHEST_AXIS_SPEED;
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView, descriptor_numbers};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// The field `vel` of a motion descriptor gets a constant above 1000.
    ///
    /// ## Why
    /// `vel`, `accel` and `decel` are in per cent of the nominal values of the arm (10.5.1), while `tvel` is in mm/s. A
    /// move with such a descriptor stops its task with run-time error 100. Usually a speed in mm/s was written into the
    /// wrong field.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast.vel=25000
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast.vel=100
    /// mFast.tvel=25000
    /// ```
    V0245 "percent-out-of-range" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for number in descriptor_numbers(program) {
        if number.field == AXIS_SPEED && number.value > HIGHEST_AXIS_SPEED {
            found.report(&RULE, program.range(number.at), word(number.value));
        }
    }
}

pub(super) fn word(number: f64) -> Wording {
    Wording::new(
        format!("`{AXIS_SPEED}` of a motion descriptor is in per cent, and cannot be {}", num(number)),
        format!("every move with it fails: {}", runtime_error(BAD_VEL)),
        "100 is the nominal value; the speed of the tool in mm/s is `tvel`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn speeds_in_millimetres_are_reported() {
        expect![[r#"
            start.pgx:5 `25000` `vel` of a motion descriptor is in per cent, and cannot be 25000
              | every move with it fails: run-time error 100: bad vel in the mdesc
              ? 100 is the nominal value; the speed of the tool in mm/s is `tvel`
            start.pgx:6 `2000` `vel` of a motion descriptor is in per cent, and cannot be 2000
              | every move with it fails: run-time error 100: bad vel in the mdesc
              ? 100 is the nominal value; the speed of the tool in mm/s is `tvel`
        "#]]
        .assert_eq(&check(&RULE, "mdesc mA\nmA.vel=25000\nmA={100,2000,100,9999,9999,joint,50,50}"));
    }

    #[test]
    fn percentages_that_programs_use_are_not_reported() {
        assert_eq!(check(&RULE, "mdesc mA\nmA.vel=500\nmA.accel=9999\nmA.tvel=25000\nmA.rvel=99999"), "");
    }
}
