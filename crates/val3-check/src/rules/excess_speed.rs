//! V0415: a motion descriptor with a speed above an axis's maximum speed.

use val3_kinematics::{Arm, ExcessSpeed};
use val3_lang::motion::AXIS_SPEED;
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView, arm_of_project, descriptor_numbers};
use crate::rule::rule;

rule! {
    /// The field `vel` of a motion descriptor is set to a constant with which an axis of the cell's arm exceeds its
    /// maximum speed.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// `vel` is a percentage of the nominal speed of each axis (10.5.1). Above 100 it is allowed up to the maximum
    /// speed, which differs from axis to axis. Beyond it, the controller may stop the move with an error (10.3.4).
    /// `val3 run` moves the axis at the speed in the descriptor, so its times are too short.
    ///
    /// The arm is that of `--arm`, `val3.toml` or `arm.cfx`. All axes count as moving, and limits by `tvel` and `rvel` are
    /// not considered. Arms whose maximum speeds are choices of the model, because no public source has them, report nothing.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast.vel=200
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mFast
    ///
    /// mFast.vel=100
    /// ```
    V0415 "excess-speed" Info off, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(arm) = arm_of_project(program.db, program.project) else { return };
    for number in descriptor_numbers(program).into_iter().filter(|number| number.field == AXIS_SPEED) {
        if let Some(excess) = arm.model.excess_speed(number.value, |_| true) {
            found.report(&RULE, program.range(number.at), word(&arm.model, number.value, &excess));
        }
    }
}

pub(super) fn word(arm: &Arm, vel: f64, excess: &ExcessSpeed) -> Wording {
    Wording::new(
        format!(
            "`{AXIS_SPEED}` = {} moves axis {} of the {} faster than its maximum speed",
            num(vel),
            excess.axis,
            arm.name()
        ),
        excess.to_string(),
        format!("write at most {}", excess.greatest_vel),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn speeds_beyond_the_maximum_are_reported() {
        expect![[r#"
            start.pgx:5 `200` `vel` = 200 moves axis 4 of the TX2-90 faster than its maximum speed
              | axis 4 may move at 900 degrees/s, its maximum is 540 degrees/s
              ? write at most 120
            start.pgx:6 `121` `vel` = 121 moves axis 4 of the TX2-90 faster than its maximum speed
              | axis 4 may move at 544.5 degrees/s, its maximum is 540 degrees/s
              ? write at most 120
        "#]]
        .assert_eq(&check(&RULE, "mdesc m\nm.vel=200\nm={100,121,100,250,90,off,,}"));
    }

    #[test]
    fn possible_speeds_and_other_fields_are_not_reported() {
        assert_eq!(check(&RULE, "mdesc m\nm.vel=120\nm.accel=1000\nm={1000,100,1000,9999,9999,off,,}"), "");
    }

    fn speed_on_arm(name: &str) -> String {
        format!("mdesc m\nm.vel=1000\n=== /configs/arm.cfx\n<arm><String name=\"arm\" value=\"{name}\"/></arm>\n")
    }

    /// The maximum speeds of these arms are assumptions of the model.
    #[test]
    fn arms_without_public_maximum_speeds_report_nothing() {
        assert_eq!(check(&RULE, &speed_on_arm("ts60-S1-D20-L200")), "");
        assert!(check(&RULE, &speed_on_arm("tx60-S1")).contains("TX60"));
    }
}
