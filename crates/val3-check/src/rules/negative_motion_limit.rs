//! V0231: a negative number in a motion descriptor.

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView, descriptor_numbers};
use crate::rule::rule;

rule! {
    /// A field of a motion descriptor gets a constant below 0.
    ///
    /// ## Why
    /// Speeds, accelerations and blending distances are never negative (10.5.1). The assignment is accepted, but every
    /// move with this descriptor stops its task with a run-time error from 100 to 106.
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
    for number in descriptor_numbers(program).into_iter().filter(|number| number.value < 0.0) {
        found.report(&RULE, program.range(number.at), word(number.field, number.value));
    }
}

pub(super) fn word(field: &str, number: f64) -> Wording {
    Wording::new(
        format!("`{field}` of a motion descriptor cannot be {number}"),
        "every move with it fails",
        "write 0 or more",
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
              ? write 0 or more
        "#]]
        .assert_eq(&check(&RULE, "mdesc m\nm.leave=-5\nm={100,-1,100,250,90,off,,}"));
    }

    #[test]
    fn other_fields_are_not_reported() {
        assert_eq!(check(&RULE, "mdesc m\ntrsf t\nm.leave=0\nt.x=-5\nm={100,1,100,250,90,off,,}\nt={-1,,,,,}"), "");
    }
}
