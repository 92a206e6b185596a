//! V0420: a position at which the arm touches a thing of its cell.

use val3_analysis::items::parse;
use val3_analysis::items::positions::{PositionElement, each};
use val3_analysis::placement::shown;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{CellContacts, DataFile, Findings, PositionContact};
use crate::rule::rule;

rule! {
    /// At a position of a data file, the arm or what it carries touches a thing of its cell.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// A move to the position ends in a collision: the position was taught in another cell, its frame has moved, or
    /// `cell.toml` describes a thing at the wrong place.
    ///
    /// Compared are the links, and the objects that the arm carries, with the objects that stand. Parts are not, because
    /// grippers move them, nor objects in frames and tools that a program changes or that belong to a library. A pair in
    /// `allow` may touch. An arm without the shapes of its links (`[shapes]` in its description) is compared with what it
    /// carries only.
    ///
    /// A point is compared with the tools of the moves to it, in all configurations that it allows, and is reported only
    /// if all of them touch something. Positions that a program changes, that were not taught or that only serve
    /// computations are not reported.
    ///
    /// ## Bad
    /// ```val3
    /// movej(pPick,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="600" z="200" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === main/cell.toml
    /// [[object]]
    /// name = "table"
    /// box = [400, 600, 40]
    /// at = [600, 0, 230]
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(pPick,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="600" z="300" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === main/cell.toml
    /// [[object]]
    /// name = "table"
    /// box = [400, 600, 40]
    /// at = [600, 0, 230]
    /// ```
    V0420 "contact-at-position" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(contacts) = CellContacts::new(&data.view) else { return };
    let parse = parse(data.view.db, data.file);
    each(parse.view(), &mut |value| position(&value, &contacts, found));
}

fn position(value: &PositionElement<'_>, contacts: &CellContacts<'_>, found: &mut Findings) {
    let is_position = |ty| matches!(ty, BaseType::Point | BaseType::Joint);
    let Some(position) = value.read().filter(|position| is_position(position.ty)) else { return };
    if let Some(contact) = contacts.at_position(&value.path, &position) {
        found.report(&RULE, value.range(), word(&value.path, &contact));
    }
}

fn word(path: &str, PositionContact { contact, others, tool }: &PositionContact) -> Wording {
    let [first, second] = &contact.names;
    let kind = if tool.is_some() { "point" } else { "joint position" };
    let tool = tool.as_ref().and_then(|tool| tool.path.as_deref());
    let tool = tool.map(|tool| format!(" with the tool `{}`", shown(tool))).unwrap_or_default();
    let overlap = contact.depth.map_or("they touch".to_owned(), |depth| format!("they overlap by {depth:.1} mm"));
    let others = match others {
        0 => String::new(),
        1 => ", and another pair touches".to_owned(),
        count => format!(", and {count} other pairs touch"),
    };
    Wording::new(
        format!("at the {kind} `{}`{tool}, `{first}` touches `{second}`", shown(path)),
        format!("{overlap}{others}"),
        allow_help("correct the position, its frame or `cell.toml`", first, second),
    )
}

/// Help that ends with the line by which `cell.toml` allows a contact.
pub(super) fn allow_help(advice: &str, first: &str, second: &str) -> String {
    format!("{advice}, or allow the pair there: `allow = [[\"{first}\", \"{second}\", \"why\"]]`")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    const TABLE: &str = "[[object]]\nname = \"table\"\nbox = [400, 600, 40]\nat = [600, 0, 230]\n";

    fn found_with(cell: &str, code: &str) -> String {
        let points = [
            "x=\"600\" z=\"200\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"600\" z=\"450\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"600\" z=\"350\" rx=\"180\" fatherId=\"world[0]\"",
        ];
        let data = data("pX", "pointRx", &points)
            + &data("jX", "jointRx", &["j2=\"90\"", "j3=\"90\" j5=\"90\""])
            + &data("tLong", "tool", &["z=\"120\" fatherId=\"flange[0]\" ioLink=\"valve1\""])
            + &data("fMoved", "frame", &["z=\"10\" fatherId=\"world[0]\""]);
        check(&RULE, &format!("{}\n=== main/cell.toml\n{cell}", listing(code, &data)))
    }

    #[test]
    fn positions_in_a_thing_are_reported() {
        expect![[r#"
            main.dtx:5 `0` at the point `pX`, `link5` touches `table`
              | they overlap by 61.0 mm, and 2 other pairs touch
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link5", "table", "why"]]`
        "#]]
        .assert_eq(&found_with(TABLE, "movej(pX[0],flange,mX)\nmovej(pX[1],flange,mX)\nmovej(jX[1],flange,mX)"));
        let post = "[[object]]\nname = \"post\"\nbox = [100, 100, 2000]\nat = [700, 0, 0]\n";
        expect![[r#"
            main.dtx:5 `0` at the point `pX`, `link4` touches `post`
              | they overlap by 45.5 mm
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link4", "post", "why"]]`
            main.dtx:6 `1` at the point `pX[1]`, `link4` touches `post`
              | they overlap by 44.4 mm
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link4", "post", "why"]]`
            main.dtx:7 `2` at the point `pX[2]`, `link4` touches `post`
              | they overlap by 44.8 mm
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link4", "post", "why"]]`
            main.dtx:10 `0` at the joint position `jX`, `link4` touches `post`
              | they overlap by 96.0 mm, and another pair touches
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link4", "post", "why"]]`
        "#]].assert_eq(&found_with(post, "movej(jX[0],flange,mX)"));
    }

    #[test]
    fn what_the_arm_carries_is_compared() {
        let cell = format!(
            "{TABLE}[[object]]\nname = \"gripper\"\nin = \"tLong\"\ncapsule = {{ from = [0, 0, -60], to = [0, 0, 80], radius = 10 }}"
        );
        expect![[r#"
            main.dtx:5 `0` at the point `pX`, `link5` touches `table`
              | they overlap by 61.0 mm, and 2 other pairs touch
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["link5", "table", "why"]]`
            main.dtx:6 `1` at the point `pX[1]`, `gripper` touches `table`
              | they overlap by 10.0 mm
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["gripper", "table", "why"]]`
            main.dtx:11 `1` at the joint position `jX[1]`, `gripper` touches `table`
              | they overlap by 65.0 mm
              ? correct the position, its frame or `cell.toml`, or allow the pair there: `allow = [["gripper", "table", "why"]]`
        "#]].assert_eq(&found_with(&cell, "movej(pX[2],flange,mX)\nmovej(pX[1],tLong,mX)"));
        let allowed = format!("allow = [[\"gripper\", \"table\", \"it is soft\"]]\n{cell}");
        assert!(!found_with(&allowed, "movej(pX[2],flange,mX)").contains("gripper"));
    }

    #[test]
    fn what_is_unknown_is_not_reported() {
        let code = "movej(pX[0],flange,mX)";
        let moved = TABLE.replace("at =", "in = \"fMoved\"\nat =");
        assert_ne!(found_with(&moved, code), "");
        assert_eq!(found_with(&moved, &format!("fMoved.trsf.x=1\n{code}")), "");
        assert_eq!(found_with(TABLE, &format!("pX[0].trsf.x=1\n{code}")), "");
        assert_eq!(found_with("", code), "");
        let part = TABLE.replace("object", "part");
        assert_eq!(found_with(&part, code), "");
    }
}
