//! V0412: a joint position outside the range of an axis.

use val3_analysis::items::parse;
use val3_analysis::items::positions::{PositionElement, each};
use val3_analysis::placement::{joints, shown};
use val3_kinematics::{Arm, Violation};
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::english::and;
use crate::lint::{ArmReach, DataFile, Findings, position_of, range_of};
use crate::rule::rule;

rule! {
    /// A joint position of a data file is outside the range of an axis of the cell's arm.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// A move to the position stops the task with run-time error 154. The position belongs to another arm, or the limits
    /// of this one are narrower.
    ///
    /// The arm is that of `--arm`, `val3.toml` or `arm.cfx`, with the limits in the configuration files of the cell.
    /// Positions that a program changes are not reported, nor joints that only serve computations, such as tolerances.
    ///
    /// ## Bad
    /// ```val3
    /// movej(jPark,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="jPark" access="private" xsi:type="array" type="jointRx" size="1">
    ///       <Value key="0" j3="170" />
    ///     </Data>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(jPark,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="jPark" access="private" xsi:type="array" type="jointRx" size="1">
    ///       <Value key="0" j3="140" />
    ///     </Data>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    V0412 "joint-out-of-range" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(reach) = ArmReach::new(&data.view) else { return };
    let parse = parse(data.view.db, data.file);
    each(parse.view(), &mut |value| joint(&value, data, &reach, found));
}

fn joint(value: &PositionElement<'_>, data: &DataFile<'_>, reach: &ArmReach<'_>, found: &mut Findings) {
    let path = value.path.as_str();
    let Some(position) = value.read().filter(|position| position.ty == BaseType::Joint) else { return };
    if !reach.is_known(path, &position) || !reach.is_target(path) {
        return;
    }
    let joints = joints(data.view.db, data.view.project, &position, reach.arm);
    let violations: Vec<Violation> = reach.arm.violations(&joints).collect();
    if !violations.is_empty() {
        found.report(&RULE, value.range(), word(path, reach.arm, &violations));
    }
}

fn word(path: &str, arm: &Arm, violations: &[Violation]) -> Wording {
    let path = shown(path);
    let axes: Vec<String> = violations
        .iter()
        .map(|violation| format!("axis {} at {}", violation.axis, position_of(arm, violation.axis, violation.position)))
        .collect();
    let ranges: Vec<String> = violations
        .iter()
        .map(|violation| {
            let Violation { axis, min, max, .. } = *violation;
            format!("the range of axis {axis} is {}", range_of(arm, axis, [min, max]))
        })
        .collect();
    Wording::new(
        format!("the joint position `{path}` has {} outside the range of the {}", and(&axes), arm.name()),
        ranges.join(", "),
        "correct the position, or name the arm of this cell in `val3.toml` (`arm`)",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use val3_test::Fixture;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    fn found(code: &str, values: &[&str]) -> String {
        check(&RULE, &listing(code, &data("jX", "jointRx", values)))
    }

    #[test]
    fn axes_outside_of_their_range_are_reported() {
        expect![[r#"
            main.dtx:5 `0` the joint position `jX` has axis 1 at -200 and axis 3 at 150.5 outside the range of the TX2-90
              | the range of axis 1 is -180 to 180 degrees, the range of axis 3 is -145 to 145 degrees
              ? correct the position, or name the arm of this cell in `val3.toml` (`arm`)
        "#]].assert_eq(&found("movej(jX[0],flange,mX)", &["j1=\"-200\" j3=\"150.5\"", "j1=\"10\""]));
    }

    #[test]
    fn the_limits_of_the_cell_count() {
        let limits = "\n=== /configs/arm.cfx\n<arm>\n<String name=\"arm\" value=\"tx90-S1\"/>\n<FloatArray \
                      name=\"maxArmJointPos\"><Float index=\"0\" value=\"15\"/></FloatArray>\n</arm>\n";
        let listing = listing("movej(jX,flange,mX)", &data("jX", "jointRx", &["j1=\"20\""]));
        assert_eq!(check(&RULE, &listing), "");
        expect![[r#"
            main.dtx:5 `0` the joint position `jX` has axis 1 at 20 outside the range of the TX90
              | the range of axis 1 is -180 to 15 degrees
              ? correct the position, or name the arm of this cell in `val3.toml` (`arm`)
        "#]]
        .assert_eq(&check(&RULE, &(listing + limits)));
    }

    #[test]
    fn a_length_has_its_unit() {
        let listing = listing("movej(jX,flange,mX)", &data("jX", "jointRs", &["j3=\"-1\""]));
        expect![[r#"
            main.dtx:5 `0` the joint position `jX` has axis 3 at -25.4 mm outside the range of the TS2-60
              | the range of axis 3 is 0 to 200 mm
              ? correct the position, or name the arm of this cell in `val3.toml` (`arm`)
        "#]]
        .assert_eq(&check(&RULE, &Fixture::in_inches(&listing)));
    }

    #[test]
    fn joints_that_are_no_targets_are_not_reported() {
        assert_eq!(found("if jX.j1>200\nputln(1)\nendIf", &["j1=\"300\""]), "");
        assert_eq!(found("jX=herej()\nmovej(jX,flange,mX)", &["j1=\"300\""]), "");
        assert_eq!(found("movej(jX,flange,mX)", &["j1=\"x\""]), "");
    }
}
