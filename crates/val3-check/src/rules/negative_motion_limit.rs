//! V0231: a number in a motion descriptor that no move accepts.

use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView, descriptor_numbers};
use crate::rule::rule;

rule! {
    /// A field of a motion descriptor gets a constant below 0, or a speed or acceleration gets 0.
    ///
    /// ## Why
    /// Speeds and accelerations are above 0, and blending distances are not negative (10.5.1). The assignment is accepted,
    /// but every move with this descriptor stops its task with a run-time error from 100 to 106. To stop the arm, call
    /// `stopMove()`.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mSlow
    ///
    /// mSlow.vel=-10
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mSlow
    ///
    /// mSlow.vel=10
    /// ```
    V0231 "negative-motion-limit" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for number in descriptor_numbers(program) {
        if is_too_small(number.field, number.value) {
            found.report(&RULE, program.range(number.at), word(number.field, number.value));
        }
    }
}

/// Whether every move fails with this number in a field, or in an attribute of a data file.
pub(super) fn is_too_small(field: &str, number: f64) -> bool {
    number < 0.0 || (number == 0.0 && !is_distance(field))
}

fn is_distance(field: &str) -> bool {
    ["leave", "reach"].contains(&field)
}

pub(super) fn word(field: &str, number: f64) -> Wording {
    Wording::new(
        format!("`{field}` of a motion descriptor cannot be {}", num(number)),
        "every move with it fails",
        if is_distance(field) { "write 0 or more" } else { "write a number above 0" },
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn negative_fields_are_reported() {
        expect![[r#"
            start.pgx:5 `-5` `leave` of a motion descriptor cannot be -5
              | every move with it fails
              ? write 0 or more
            start.pgx:6 `-1` `vel` of a motion descriptor cannot be -1
              | every move with it fails
              ? write a number above 0
        "#]]
        .assert_eq(&check(&RULE, "mdesc m\nm.leave=-5\nm={100,-1,100,250,90,off,,}"));
    }

    #[test]
    fn speeds_of_zero_are_reported() {
        expect![[r#"
            start.pgx:5 `0` `vel` of a motion descriptor cannot be 0
              | every move with it fails
              ? write a number above 0
            start.pgx:6 `0` `accel` of a motion descriptor cannot be 0
              | every move with it fails
              ? write a number above 0
            start.pgx:7 `0` `tvel` of a motion descriptor cannot be 0
              | every move with it fails
              ? write a number above 0
        "#]]
        .assert_eq(&check(&RULE, "mdesc m\nm.vel=0\nm.accel=0\nm.tvel=0\nm.leave=0\nm.reach=0"));
    }

    #[test]
    fn other_fields_are_not_reported() {
        assert_eq!(check(&RULE, "mdesc m\ntrsf t\nm.leave=0\nt.x=-5\nm={100,1,100,250,90,off,,}\nt={-1,,,,,}"), "");
    }
}
