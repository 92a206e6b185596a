//! V0413: a move between known positions that the arm cannot make.

use val3_analysis::body::ExprId;
use val3_kinematics::Unreachable;
use val3_motion::Cause;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ImpossibleMove, ProgramView, UnreachablePath, arm_of_project};
use crate::rule::rule;

rule! {
    /// The arm of the cell cannot follow a line, a circle or a blend between known positions.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// On the way an axis would leave its range or have to jump at a singularity, a part of the path is out of reach, or
    /// the target requires another configuration than the start. The task stops with run-time error 154 at this move
    /// (10.6).
    ///
    /// Two moves are compared if one certainly follows the other and if no program changes their targets, frames and
    /// tools. `appro` of such points with a constant transformation is computed. The path is planned as `val3 run`
    /// does. Where the start can be reached in several configurations, the move is reported only if all of them fail.
    ///
    /// The corner at a move is compared if the next move certainly follows it without a stop, and no program changes
    /// `blend`, `leave` and `reach` of their descriptors. A blend that the arm cannot follow stops the task with run-time
    /// error 150 at the move after it.
    ///
    /// ## Bad
    /// ```val3
    /// movej(jReady,flange,mFast)
    /// movel(pBehind,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="jReady" access="private" xsi:type="array" type="jointRx" size="1">
    ///       <Value key="0" j3="90" j5="90" />
    ///     </Data>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pBehind" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="-500" y="50" z="300" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(jReady,flange,mFast)
    /// movej(pBehind,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="jReady" access="private" xsi:type="array" type="jointRx" size="1">
    ///       <Value key="0" j3="90" j5="90" />
    ///     </Data>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pBehind" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="-500" y="50" z="300" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0413 "impossible-move" Info off, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(arm) = arm_of_project(program.db, program.project) else { return };
    for fault in &program.planned_moves().impossible {
        let target = program.range(fault.target);
        let reported = found.report(&RULE, target, word(program, fault, arm.model.name()));
        if let Some(from) = fault.from {
            let label = if fault.shape == UnreachablePath::Blend { "the corner" } else { "the arm starts here" };
            reported.related(program.range(from), label);
        }
    }
}

fn word(program: &ProgramView<'_>, fault: &ImpossibleMove, arm: &str) -> Wording {
    let text = |id: ExprId| program.text(id);
    let (to, cause) = (text(fault.target), &fault.cause);
    let Some(from) = fault.from else {
        let help = "correct the point that it is computed from, or the transformation";
        return Wording::new(format!("the {arm} cannot reach `{to}`: {cause}"), "out of reach", help);
    };
    let path = match fault.shape {
        UnreachablePath::Line => "straight",
        UnreachablePath::Circle => "along this circle",
        UnreachablePath::Blend => return blend(text(from), text(fault.target), cause, arm),
    };
    let (label, help) = match cause {
        Cause::Unreachable(Unreachable::Limit { .. }) | Cause::OutOfRange(_) => {
            ("an axis leaves its range", "use a joint move, or turn the tool to keep away from the limit")
        }
        Cause::Configuration => ("another configuration", "reach the point with a joint move"),
        Cause::Arc(_) => ("no circle", "teach three points that are apart and not on a line"),
        Cause::Singular => ("through a singularity", "use a joint move, or add a point to move around the singularity"),
        _ => ("a part of the path is out of reach", "use a joint move, or add a point to move around it"),
    };
    Wording::new(format!("the {arm} cannot move {path} from `{}` to `{to}`: {cause}", text(from)), label, help)
}

fn blend(from: &str, to: &str, cause: &Cause, arm: &str) -> Wording {
    let message = format!("the {arm} cannot round the corner at `{from}` on the way to `{to}`: {cause}");
    let label = match cause {
        Cause::Unreachable(Unreachable::Limit { .. }) | Cause::OutOfRange(_) => "an axis leaves its range on the blend",
        Cause::Singular => "the blend passes a singularity",
        Cause::Reorientation => "the tool turns too far on the blend",
        _ => "a part of the blend is out of reach",
    };
    Wording::new(message, label, "reduce `leave` and `reach` of the move before, or stop there: `blend` = `off`")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    fn found(code: &str) -> String {
        let points = [
            "x=\"500\" y=\"100\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"-500\" y=\"100\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"500\" y=\"-100\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"500\" y=\"100\" z=\"300\" rx=\"180\" wrist=\"wnegative\" fatherId=\"world[0]\"",
            "x=\"500\" y=\"0\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"-500\" y=\"0\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
        ];
        let data = data("pX", "pointRx", &points)
            + &data("jX", "jointRx", &["j3=\"90\" j5=\"90\""])
            + &data("trX", "trsf", &["z=\"-900\"", "z=\"-50\""]);
        check(&RULE, &listing(code, &data))
    }

    #[test]
    fn paths_that_the_arm_cannot_follow_are_reported() {
        expect![[r#"
            start.pgx:6 `pX[1]` the TX2-90 cannot move straight from `jX` to `pX[1]`: axis 6 would be at 270.045, its limits are -270 and 270 degrees
              | an axis leaves its range
              ? use a joint move, or turn the tool to keep away from the limit
              > start.pgx:5 `jX` the arm starts here
        "#]].assert_eq(&found("movej(jX,flange,mX)\nmovel(pX[1],flange,mX)"));
        expect![[r#"
            start.pgx:6 `pX[5]` the TX2-90 cannot move straight from `pX[4]` to `pX[5]`: the path passes a singularity, where an axis would have to jump
              | through a singularity
              ? use a joint move, or add a point to move around the singularity
              > start.pgx:5 `pX[4]` the arm starts here
        "#]].assert_eq(&found("movej(pX[4],flange,mX)\nmovel(pX[5],flange,mX)"));
        expect![[r#"
            start.pgx:6 `pX[3]` the TX2-90 cannot move straight from `jX` to `pX[3]`: a straight line or a circle cannot change the configuration; use a joint move, or `free`
              | another configuration
              ? reach the point with a joint move
              > start.pgx:5 `jX` the arm starts here
        "#]].assert_eq(&found("movej(jX,flange,mX)\nmovel(pX[3],flange,mX)"));
        expect![[r#"
            start.pgx:6 `pX[2]` the TX2-90 cannot move along this circle from `pX[0]` to `pX[2]`: the three positions are on one line
              | no circle
              ? teach three points that are apart and not on a line
              > start.pgx:5 `pX[0]` the arm starts here
        "#]].assert_eq(&found("movej(pX[0],flange,mX)\nmovec(pX[4],pX[2],flange,mX)"));
    }

    #[test]
    fn computed_points_are_followed() {
        expect![[r#"
            start.pgx:5 `appro(pX[0],trX[0])` the TX2-90 cannot reach `appro(pX[0],trX[0])`: the centre of the wrist would be 1378.1 mm from the shoulder, the arm reaches 0.0 to 850.0 mm
              | out of reach
              ? correct the point that it is computed from, or the transformation
        "#]].assert_eq(&found("movej(appro(pX[0],trX[0]),flange,mX)"));
        let near = "movej(appro(pX[0],{0,0,-100,0,0,0}),flange,mX)\nmovel(pX[0],flange,mX)\nmovel(appro(pX[0],trX[1]),flange,mX)";
        assert_eq!(found(near), "");
    }

    /// Both lines pass axis 1 at a distance of 80 mm, and the blend between them moves the wrist too near to the axis.
    fn found_at_corner(corner: &str, descriptor: &str) -> String {
        let points = [
            "x=\"80\" y=\"300\" z=\"325\" rx=\"180\" rz=\"180\" fatherId=\"world[0]\"",
            "x=\"80\" y=\"-80\" z=\"325\" rx=\"180\" rz=\"180\" fatherId=\"world[0]\"",
            "x=\"-300\" y=\"-80\" z=\"325\" rx=\"180\" rz=\"180\" fatherId=\"world[0]\"",
        ];
        let data = data("jX", "jointRx", &["j3=\"90\" j5=\"90\""])
            + &data("mB", "mdesc", &[descriptor, "blend=\"off\""])
            + &data("pX", "pointRx", &points);
        let start = "movej(jX,flange,mB[1])\nmovej(pX[0],flange,mB[1])\nmovel(pX[1],flange,mB[0])\n";
        check(&RULE, &listing(&format!("{start}{corner}movel(pX[2],flange,mB[1])"), &data))
    }

    const TOO_WIDE: &str = "blend=\"cartesian\" leave=\"200\" reach=\"200\"";

    #[test]
    fn corners_that_the_arm_cannot_round_are_reported() {
        expect![[r#"
            start.pgx:8 `pX[2]` the TX2-90 cannot round the corner at `pX[1]` on the way to `pX[2]`: the centre of the wrist would be 49.9 mm from axis 1, the arm needs at least 50.0 mm
              | a part of the blend is out of reach
              ? reduce `leave` and `reach` of the move before, or stop there: `blend` = `off`
              > start.pgx:7 `pX[1]` the corner
        "#]].assert_eq(&found_at_corner("", TOO_WIDE));
        assert_eq!(found_at_corner("delay(1)\n", TOO_WIDE).lines().count(), 4);
    }

    #[test]
    fn corners_that_can_be_rounded_or_are_not_known_are_not_reported() {
        assert_eq!(found_at_corner("", "blend=\"cartesian\" leave=\"20\" reach=\"20\""), "");
        assert_eq!(found_at_corner("", "blend=\"off\" leave=\"200\" reach=\"200\""), "");
        assert_eq!(found_at_corner("waitEndMove()\n", TOO_WIDE), "");
        assert_eq!(found_at_corner("if 1==herej().j1\nwaitEndMove()\nendIf\n", TOO_WIDE), "");
        assert_eq!(found_at_corner("mB[0].leave=1\n", TOO_WIDE), "");
    }

    #[test]
    fn possible_and_unknown_moves_are_not_reported() {
        let codes = [
            "movej(jX,flange,mX)\nmovel(pX[0],flange,mX)\nmovel(pX[2],flange,mX)",
            "movel(pX[1],flange,mX)",
            "movej(jX,flange,mX)\nif 1==herej().j1\nmovej(pX[1],flange,mX)\nendIf\nmovel(pX[1],flange,mX)",
            "movej(jX,flange,mX)\nmovel(pX[1],flange,mX)\njX.j1=10",
            "movej(jX,flange,mX)\nmovej(pX[1],flange,mX)\nmovej(jX,flange,mX)\nmovel(pX[0],flange,mX)",
            "while true\nmovel(pX[0],flange,mX)\nmovel(pX[2],flange,mX)\nendWhile",
        ];
        for code in codes {
            assert_eq!(found(code), "", "{code}");
        }
    }
}
