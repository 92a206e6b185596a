//! V0421: a move between known positions in which the arm touches a thing of its cell.

use crate::diagnostic::Wording;
use crate::lint::{CellContacts, Findings, MoveContact, ProgramView, ProjectView};
use crate::rule::rule;
use crate::rules::contact_at_position::allow_help;

rule! {
    /// In a move between known positions, the arm or what it carries touches a thing of its cell.
    ///
    /// This rule is off unless `val3 check --motion` or `motion = true` in the table `[lint]` of `val3.toml` turns it on.
    ///
    /// ## Why
    /// Start and end of the move are free, and something stands between them. `V0420` reports positions, and describes
    /// what is compared.
    ///
    /// Two moves are compared if one certainly follows the other and if no program changes their targets, frames and
    /// tools. The path is planned as `val3 run` does, up to the target: a corner that is rounded is compared as if the
    /// arm stopped there. Where the start can be reached in several configurations, the move is reported only if there is
    /// a contact from all of them.
    ///
    /// ## Bad
    /// ```val3
    /// movej(pLeft,flange,mFast)
    /// movel(pRight,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pLeft" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="500" y="300" z="300" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pRight" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="500" y="-300" z="300" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === main/cell.toml
    /// [[object]]
    /// name = "post"
    /// box = { min = [480, -20, -400], max = [520, 20, 320] }
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(pLeft,flange,mFast)
    /// movel(pRight,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pLeft" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="500" y="300" z="400" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pRight" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="500" y="-300" z="400" rx="180" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === main/cell.toml
    /// [[object]]
    /// name = "post"
    /// box = { min = [480, -20, -400], max = [520, 20, 320] }
    /// ```
    V0421 "contact-in-move" Info off, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let view = ProjectView::new(program.db, program.project, program.options);
    let Some(contacts) = CellContacts::new(&view) else { return };
    for contact in contacts.in_moves(program) {
        let reported = found.report(&RULE, program.range(contact.target), word(program, &contact));
        reported.related(program.range(contact.from), "the arm starts here");
    }
}

fn word(program: &ProgramView<'_>, MoveContact { target, from, contact, distance }: &MoveContact) -> Wording {
    let [first, second] = &contact.names;
    let (from, to) = (program.text(*from), program.text(*target));
    Wording::new(
        format!("on the way from `{from}` to `{to}`, `{first}` touches `{second}`"),
        format!("the tool centre point is {distance:.0} mm from `{from}` then"),
        allow_help("add a point to move around it", first, second),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::motion_testing::{data, listing};
    use crate::lint::testing::check;

    const POST: &str = "[[object]]\nname = \"post\"\nbox = { min = [480, -20, -400], max = [520, 20, 320] }\n";

    fn found(cell: &str, code: &str) -> String {
        let points = [
            "x=\"500\" y=\"300\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"500\" y=\"-300\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"500\" z=\"400\" rx=\"180\" fatherId=\"world[0]\"",
            "x=\"500\" z=\"300\" rx=\"180\" fatherId=\"world[0]\"",
        ];
        let data = data("pX", "pointRx", &points) + &data("jX", "jointRx", &["j3=\"90\" j5=\"90\""]);
        check(&RULE, &format!("{}\n=== main/cell.toml\n{cell}", listing(code, &data)))
    }

    #[test]
    fn contacts_on_lines_and_joint_moves_are_reported() {
        expect![[r#"
            start.pgx:6 `pX[1]` on the way from `pX[0]` to `pX[1]`, `link4` touches `post`
              | the tool centre point is 232 mm from `pX[0]` then
              ? add a point to move around it, or allow the pair there: `allow = [["link4", "post", "why"]]`
              > start.pgx:5 `pX[0]` the arm starts here
        "#]].assert_eq(&found(POST, "movej(pX[0],flange,mX)\nmovel(pX[1],flange,mX)"));
        expect![[""]].assert_eq(&found(POST, "movej(pX[0],flange,mX)\nmovej(pX[1],flange,mX)"));
        assert_eq!(found(POST, "movej(pX[0],flange,mX)\nmovel(pX[2],flange,mX)"), "");
    }

    #[test]
    fn a_contact_at_a_computed_target_is_reported_once() {
        let code = "movej(pX[2],flange,mX)\nmovel(appro(pX[2],{0,0,100,0,0,0}),flange,mX)\nmovel(pX[2],flange,mX)";
        expect![[r#"
            start.pgx:6 `appro(pX[2],{0,0,100,0,0,0})` on the way from `pX[2]` to `appro(pX[2],{0,0,100,0,0,0})`, `link6` touches `post`
              | the tool centre point is 47 mm from `pX[2]` then
              ? add a point to move around it, or allow the pair there: `allow = [["link6", "post", "why"]]`
              > start.pgx:5 `pX[2]` the arm starts here
        "#]].assert_eq(&found(POST, code));
    }

    #[test]
    fn contacts_at_positions_and_from_unknown_starts_are_not_reported() {
        assert_eq!(found(POST, "movej(pX[2],flange,mX)\nmovel(pX[3],flange,mX)\nmovel(pX[2],flange,mX)"), "");
        assert_eq!(found(POST, "movel(pX[1],flange,mX)"), "");
        assert_eq!(found(POST, "movej(pX[0],flange,mX)\npX[1].trsf.y=herej().j1\nmovel(pX[1],flange,mX)"), "");
    }
}
