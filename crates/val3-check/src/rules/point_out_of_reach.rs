//! V0411: a point that the arm of the cell cannot reach.

use val3_analysis::items::parse;
use val3_analysis::items::positions::{PositionElement, each};
use val3_analysis::placement::shown;
use val3_analysis::reach::configuration_words;
use val3_kinematics::{Arm, Joints, Unreachable};
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::english::all_of;
use crate::lint::{ArmReach, DataFile, Findings, FlangeTool, position_of, range_of};
use crate::rule::rule;

rule! {
    /// The arm of the cell cannot reach a point of a data file.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// A move to the point stops the task with run-time error 154. The point belongs to another cell, its frame has
    /// moved, or it was typed wrongly.
    ///
    /// The arm is that of `--arm`, `val3.toml` or `arm.cfx`. A point is compared with the tools of the moves to it. If
    /// they are unknown, the point is reported only if it is unreachable with every tool of the application. Points
    /// with only zeros have not been taught and are not reported. Neither are points that a program changes, that have
    /// no father, or that only serve computations.
    ///
    /// ## Bad
    /// ```val3
    /// movej(pFar,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pFar" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="1800" z="200" ry="90" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(pNear,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pNear" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="800" z="200" ry="90" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0411 "point-out-of-reach" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(reach) = ArmReach::new(&data.view) else { return };
    let parse = parse(data.view.db, data.file);
    each(parse.view(), &mut |value| point(&value, &reach, found));
}

fn point(value: &PositionElement<'_>, reach: &ArmReach<'_>, found: &mut Findings) {
    let path = value.path.as_str();
    let Some(position) = value.read().filter(|position| position.ty == BaseType::Point) else { return };
    if !reach.is_known(path, &position) || !reach.is_target(path) {
        return;
    }
    if let Some((tool, reason)) = reach.unreachable(path, &position) {
        let other = reach.other_configuration(path, &tool);
        found.report(&RULE, value.range(), word(path, reach.arm, &tool, &reason, other));
    }
}

fn word(path: &str, arm: &Arm, tool: &FlangeTool, reason: &Unreachable, other: Option<Joints>) -> Wording {
    let name = arm.name();
    let path = shown(path);
    let tool = tool.path.as_deref().map(|tool| format!(" with the tool `{}`", shown(tool))).unwrap_or_default();
    let (problem, label) = match *reason {
        Unreachable::OutOfReach { distance, max, .. } if distance > max => (
            format!("is {:.1} mm beyond the reach of the {name}{tool}", distance - max),
            format!("the wrist would be {distance:.1} mm from the shoulder, at most {max:.1} mm is possible"),
        ),
        Unreachable::OutOfReach { distance, min, .. } => (
            format!("is {:.1} mm too close to the shoulder of the {name}{tool}", min - distance),
            format!("the wrist would be {distance:.1} mm from the shoulder, at least {min:.1} mm is needed"),
        ),
        Unreachable::InsideCylinder { distance, radius } => (
            format!("is {:.1} mm too close to axis 1 of the {name}{tool}", radius - distance),
            format!("the wrist would be {distance:.1} mm from axis 1, at least {radius:.1} mm is needed"),
        ),
        Unreachable::Limit { axis, position, min, max, .. } => (
            format!(
                "needs axis {axis} of the {name}{tool} at {}, outside its range",
                position_of(arm, axis, format_args!("{position:.1}"))
            ),
            format!("the range of axis {axis} is {}", range_of(arm, axis, [min, max])),
        ),
        Unreachable::Tilted { angle } => (
            format!("tilts the flange of the {name}{tool} by {angle:.1} degrees"),
            "the flange of this arm stays vertical".to_owned(),
        ),
        Unreachable::NotConverged => (format!("cannot be reached by the {name}{tool}"), "out of reach".to_owned()),
    };
    match other {
        None => Wording::new(
            format!("the point `{path}` {problem}"),
            label,
            "correct the point or its frames, or name the arm of this cell in `val3.toml` (`arm`)",
        ),
        Some(joints) => Wording::new(
            format!("in its configuration, the point `{path}` {problem}"),
            label,
            format!("the arm reaches the point as {}", all_of(&configuration_words(arm, &joints))),
        ),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    const FAR: &str = "x=\"1500\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"";
    const NEAR: &str = "x=\"500\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"";

    fn points(code: &str, values: &[&str]) -> String {
        check(&RULE, &listing(code, &data("pX", "pointRx", values)))
    }

    #[test]
    fn each_value_says_why_it_is_out_of_reach() {
        let values = [
            FAR,
            NEAR,
            "x=\"60\" z=\"-100\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"200\" y=\"10\" z=\"478\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"800\" z=\"300\" rx=\"180\" shoulder=\"righty\" fatherId=\"world[0]\"",
        ];
        expect![[r#"
            main.dtx:5 `0` the point `pX` is 653.4 mm beyond the reach of the TX2-90
              | the wrist would be 1503.4 mm from the shoulder, at most 850.0 mm is possible
              ? correct the point or its frames, or name the arm of this cell in `val3.toml` (`arm`)
            main.dtx:7 `2` the point `pX[2]` needs axis 2 of the TX2-90 at -178.9, outside its range
              | the range of axis 2 is -130 to 147.5 degrees
              ? correct the point or its frames, or name the arm of this cell in `val3.toml` (`arm`)
            main.dtx:9 `4` in its configuration, the point `pX[4]` is 88.0 mm beyond the reach of the TX2-90
              | the wrist would be 938.0 mm from the shoulder, at most 850.0 mm is possible
              ? the arm reaches the point as `lefty`, `epositive` and `wpositive`
        "#]]
        .assert_eq(&points("movej(pX[0],flange,mX)", &values));
    }

    /// Checks code with a point and two tools.
    fn point_and_tools(code: &str, point: &str) -> String {
        let tools = ["z=\"1000\" ry=\"-90\" fatherId=\"flange[0]\"", "z=\"10\" fatherId=\"flange[0]\""];
        check(&RULE, &listing(code, &(data("tLong", "tool", &tools) + &data("pX", "pointRx", &[point]))))
    }

    #[test]
    fn a_point_is_compared_with_the_tools_of_its_moves() {
        expect![[r#"
            main.dtx:9 `0` the point `pX` is 656.0 mm beyond the reach of the TX2-90 with the tool `tLong[1]`
              | the wrist would be 1506.0 mm from the shoulder, at most 850.0 mm is possible
              ? correct the point or its frames, or name the arm of this cell in `val3.toml` (`arm`)
        "#]]
        .assert_eq(&point_and_tools("movej(pX,tLong[1],mX)", FAR));
        expect![[""]].assert_eq(&point_and_tools("movej(appro(pX,{0,0,-5,0,0,0}),tLong[0],mX)", NEAR));
        // Any tool is possible.
        assert_eq!(point_and_tools("call go(pX)\nprogram go(point x_p)\nbegin\nmovej(x_p,flange,mX)\nend", NEAR), "");
    }

    #[test]
    fn points_whose_place_is_not_known_are_not_reported() {
        let codes = [
            "pX=here(flange,world)\nmovej(pX,flange,mX)",
            "pX.trsf.x=10\nmovej(pX,flange,mX)",
            "if distance(pX,pX)>1\nputln(1)\nendIf",
        ];
        for code in codes {
            assert_eq!(points(code, &[FAR]), "", "{code}");
        }
        for value in ["fatherId=\"world[0]\"", "x=\"1500\"", "x=\"1500\" fatherId=\"fMissing[0]\""] {
            assert_eq!(points("movej(pX,flange,mX)", &[value]), "", "{value}");
        }
        let frames =
            data("fA", "frame", &["x=\"9000\" fatherId=\"fB[0]\""]) + &data("fB", "frame", &["fatherId=\"fA[0]\""]);
        let looped = frames + &data("pX", "pointRx", &["x=\"1\" fatherId=\"fA[0]\""]);
        assert_eq!(check(&RULE, &listing("movej(pX,flange,mX)", &looped)), "");
        let two_arms = data("pX", "pointRs", &[FAR]) + &data("pY", "pointRx", &[NEAR]);
        assert_eq!(check(&RULE, &listing("movej(pY,flange,mX)", &two_arms)), "");
    }

    fn check_reference(code: &str) -> String {
        let programs = format!(
            "call go(pX)\nprogram go(point& x_p)\nbegin\ncall on(x_p)\nend\nprogram on(point& x_pNext)\nbegin\n{code}\nend"
        );
        points(&programs, &[FAR])
    }

    /// A called program may change a parameter by reference, or only read it.
    #[test]
    fn a_point_by_reference_is_not_reported_if_a_program_changes_it() {
        let reported = check_reference("movej(x_pNext,flange,mX)");
        assert!(reported.contains("beyond the reach"), "{reported}");
        for code in ["x_pNext=here(flange,world)", "x_pNext.trsf.x=1", "call on(x_pNext)\nx_pNext.trsf={0,0,0,0,0,0}"] {
            assert_eq!(check_reference(code), "", "{code}");
        }
    }

    #[test]
    fn the_old_dialect_and_inches_are_read() {
        let old = "movej(pX[1],flange,mX)\n\n=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<dataList \
             xmlns=\"DataNameSpace\">\n  <mdescSection>\n    <mdesc name=\"mX\" public=\"false\" />\n  \
             </mdescSection>\n  <pointSection>\n    <point name=\"pX\" public=\"false\" size=\"2\">\n      \
             <pFather alias=\"\" name=\"world\" fatherIndex=\"0\" />\n      <valuePoint index=\"0\">\n        \
             <tpValue x=\"500\" y=\"0\" z=\"300\" rx=\"180\" ry=\"0\" rz=\"0\" />\n      </valuePoint>\n      \
             <valuePoint index=\"1\">\n        \
             <tpValue x=\"500\" y=\"1500\" z=\"300\" rx=\"180\" ry=\"0\" rz=\"0\" />\n        \
             <cpValue shoulder=\"lefty\" elbow=\"epositive\" wrist=\"wpositive\" />\n      </valuePoint>\n    \
             </point>\n  </pointSection>\n</dataList>\n";
        expect![[r#"
            main.dtx:12 `1` the point `pX[1]` is 731.8 mm beyond the reach of the TX2-90
              | the wrist would be 1581.8 mm from the shoulder, at most 850.0 mm is possible
              ? correct the point or its frames, or name the arm of this cell in `val3.toml` (`arm`)
        "#]]
        .assert_eq(&check(&RULE, old));
        let inches = "=== main/main.pjx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Project \
             xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n<Parameters version=\"s7.11\" \
             stackSize=\"5000\" millimeterUnit=\"false\"/>\n<Programs>\n<Program file=\"start.pgx\"/>\n</Programs>\n\
             <Database>\n<Data file=\"main.dtx\"/>\n</Database>\n<Libraries/>\n</Project>\n";
        let point = data("pX", "pointRx", &[NEAR]);
        assert_eq!(check(&RULE, &listing("movej(pX,flange,mX)", &point)), "");
        let found = check(&RULE, &(listing("movej(pX,flange,mX)", &point) + inches));
        assert!(found.contains("beyond the reach"), "{found}");
    }

    #[test]
    fn frames_move_their_points() {
        let frames = data("fA", "frame", &["x=\"1000\" fatherId=\"world[0]\""]);
        let point = data("pX", "pointRx", &["x=\"500\" z=\"300\" rx=\"180\" fatherId=\"fA\""]);
        let found = |code: &str| check(&RULE, &listing(code, &(frames.clone() + &point)));
        assert!(found("movej(pX,flange,mX)").contains("beyond the reach"));
        assert_eq!(found("fA.trsf.x=0\nmovej(pX,flange,mX)"), "");
    }
}
