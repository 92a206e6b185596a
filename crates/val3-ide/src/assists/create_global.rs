//! Declares an unresolved name as global data of the application.

use memchr::memmem;
use val3_analysis::body::{Body, body};
use val3_analysis::items::program::header;
use val3_analysis::items::project::program_files;

use super::context::Context;
use super::expected::unknown;
use super::{AssistKind, Assists};
use crate::declare;
use crate::edit::SourceChange;
use crate::variables::declares_variable;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let unknown = unknown(context)?;
    let title = format!("Create global `{} {}`", unknown.shown(context.db), unknown.name);
    let variable = unknown.variable(context, true, users(context, &unknown.name))?;
    let edit = declare::data(context.db, context.project, &variable, None)?;
    assists.add_in(Some("Create"), "create-global", AssistKind::QuickFix, title, || Some(SourceChange::of([edit])));
    Some(())
}

/// Programs of the application in which the name would resolve to the new data.
fn users<'db>(context: &Context<'db>, name: &str) -> impl Iterator<Item = &'db Body> {
    let db = context.db;
    let files = program_files(db, context.project).iter().copied();
    let naming = files.filter(|file| memmem::find(file.text(db).as_bytes(), name.as_bytes()).is_some());
    let users: Vec<_> = naming.filter(|file| !declares_variable(header(db, *file), name)).collect();
    users.into_iter().map(|file| body(db, file))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, done, offered};

    const ID: &str = "create-global";

    #[test]
    fn new_data_follow_the_existing_data() {
        check(
            ID,
            "num nA\nnA=n$0B",
            expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1" />
        "#]],
        );
        check(
            ID,
            "n$0B=1",
            expect![[r#"
            usrapp/main/main.dtx
            -  <Datas />
            +  <Datas>
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1" />
            +  </Datas>
        "#]],
        );
        check(
            ID,
            "tool tA\nmdesc mA\nmovel(pHo$0me,tA,mA)",
            expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="pHome" access="private" xsi:type="array" type="pointRx" size="1">
            +      <Value key="0" fatherId="world[0]" />
            +    </Data>
        "#]],
        );
        check(
            ID,
            "dI$0n[\"a\"]=true",
            expect![[r#"
                usrapp/main/main.dtx
                -  <Datas />
                +  <Datas>
                +    <Data name="dIn" access="private" xsi:type="collection" type="dio" />
                +  </Datas>
            "#]],
        );
    }

    fn declared(listing: &str) -> String {
        let expected = done(listing, ID);
        expected.lines().filter(|line| line.starts_with('+')).collect()
    }

    #[test]
    fn an_array_holds_every_index_that_is_used() {
        for (code, expected) in [
            ("x$0[2]=1", "size=\"3\""),
            ("x$0[0]=1", "size=\"1\""),
            ("num nI\nx$0[nI]=1", "size=\"1\""),
            ("num nI\nfor nI=9 to 0 step -1\n  x$0[nI]=nI\nendFor", "size=\"10\""),
            ("x$0[1,4]=x[2,0]", "size=\"3 5\""),
            (
                "x$0[1]=1\nprogram other()\nbegin\n  x[4]=1\nend\nprogram third()\n  num x[9]\nbegin\n  x[8]=1\nend",
                "size=\"5\"",
            ),
        ] {
            let declared = declared(code);
            assert!(declared.contains(expected), "{code}: {declared}");
        }
        assert_eq!(offered("x$0[99999999]=1", ID), None);
    }

    #[test]
    fn every_position_of_an_array_has_a_father() {
        check(
            ID,
            "tool tA\nmdesc mA\nmovel(pHo$0me[1],tA,mA)",
            expect![[r#"
                usrapp/main/main.dtx
                +    <Data name="pHome" access="private" xsi:type="array" type="pointRx" size="2">
                +      <Value key="0" fatherId="world[0]" />
                +      <Value key="1" fatherId="world[0]" />
                +    </Data>
            "#]],
        );
    }

    #[test]
    fn arrays_of_s6_are_declared() {
        assert_eq!(declared(&cell_of_s6("x$0[1]=1")).matches("<valueNum").count(), 2);
        assert_eq!(offered(&cell_of_s6("x$0[1,1]=1"), ID), None);
        // Collections exist from s7 on.
        assert_eq!(offered(&cell_of_s6("dI$0n[\"a\"]=true"), ID), None);
    }

    /// A cell of s6 with this code and without data.
    fn cell_of_s6(code: &str) -> String {
        format!(
            "{code}\n=== main/main.pjx\n<project xmlns=\"ProjectNameSpace\"><parameters version=\"s6.8\" stackSize=\"5000\" millimeterUnit=\"true\" /><programSection><program file=\"start.pgx\" /></programSection><dataSection><data file=\"main.dtx\" /></dataSection></project>\n=== main/main.dtx\n<dataList><numSection/><dioSection/></dataList>\n"
        )
    }
}
