//! Declares an unknown name as global data of the application.

use super::context::Context;
use super::expected::unknown;
use super::{AssistKind, Assists};
use crate::declare;
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let unknown = unknown(context)?;
    let title = format!("Create global `{} {}`", unknown.shown(context.db), unknown.name);
    let edit = declare::data(context.db, context.project, &unknown.variable(context, true), None)?;
    assists.add_in(Some("Create"), "create-global", AssistKind::QuickFix, title, || Some(SourceChange::of([edit])));
    Some(())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::check;

    const ID: &str = "create-global";

    #[test]
    fn it_comes_behind_the_other_data() {
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
}
