//! V0416: a motion descriptor in a data file with a speed above an axis's maximum speed.

use val3_analysis::items::limits::limits;
use val3_lang::motion::AXIS_SPEED;

use super::excess_speed::word;
use crate::lint::{DataFile, Findings, arm_of_project};
use crate::rule::rule;

rule! {
    /// With a motion descriptor in a data file, an axis of the cell's arm exceeds its maximum speed.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// `vel` is a percentage of the nominal speed of each axis (10.5.1), and the controller may stop a move beyond the
    /// maximum speed of an axis with an error (10.3.4). `V0415` reports the same in programs, and its page has the details.
    ///
    /// ## Bad
    /// ```val3
    /// mdesc mFast
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" vel="200" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// mdesc mFast
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1">
    ///       <Value key="0" vel="100" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0416 "excess-speed-data" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(arm) = arm_of_project(data.view.db, data.view.project) else { return };
    for limit in limits(data.view.db, data.file).iter().filter(|limit| limit.attribute == AXIS_SPEED) {
        if let Some(excess) = arm.model.excess_speed(limit.value, |_| true) {
            found.report(&RULE, limit.range, word(&arm.model, limit.value, &excess));
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    #[test]
    fn speeds_beyond_the_maximum_are_reported() {
        let descriptors = data("mA", "mdesc", &["vel=\"100\"", "vel=\"300\" tmax=\"50\"", "accel=\"900\""]);
        expect![[r#"
            main.dtx:6 `300` `vel` = 300 moves axis 4 of the TX2-90 faster than its maximum speed
              | axis 4 may move at 1350 degrees/s, its maximum is 540 degrees/s
              ? write at most 120
        "#]]
        .assert_eq(&check(&RULE, &listing("cls()", &descriptors)));
    }

    #[test]
    fn possible_speeds_are_not_reported() {
        assert_eq!(check(&RULE, &listing("cls()", &data("mA", "mdesc", &["vel=\"120\""]))), "");
    }
}
