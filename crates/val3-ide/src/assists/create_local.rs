//! Declares an unresolved name as a local variable.

use val3_lang::types::Container;

use super::context::Context;
use super::expected::unknown;
use super::{AssistKind, Assists};
use crate::declare;
use crate::edit::SourceChange;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let unknown = unknown(context)?;
    let variable = unknown.variable(context, false, [context.body()])?;
    // A local is always an array, and cannot be linked to an input or output.
    if variable.container == Container::Collection || unknown.is_linkable() {
        return None;
    }
    let title = format!("Create local variable `{} {}`", unknown.shown(context.db), unknown.name);
    assists.add_in(Some("Create"), "create-local", AssistKind::QuickFix, title, || {
        declare::locals(context.db, context.file, &[&variable]).map(|edit| SourceChange::of([edit]))
    });
    Some(())
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "create-local";

    #[test]
    fn the_type_follows_from_the_context() {
        for (line, wanted) in [
            ("nA=$0x+1", "num x"),
            ("$0x=\"a\"", "string x"),
            ("if $0x\nendIf", "bool x"),
            ("for $0x=0 to 1\nendFor", "num x"),
            ("putln(\"a\"+$0x)", "string x"),
            ("movej($0x,tA,mA)", "joint x"),
            ("pA.trsf=$0x", "trsf x"),
            ("nA=$0x.shoulder", "config x"),
            ("nA=x$0.vel", "mdesc x"),
            ("$0l_sName=l_o", "string l_sName"),
            ("call other($0x)", "point x"),
            ("switch $0x\ncase \"a\"\nbreak\nendSwitch", "string x"),
        ] {
            let listing = format!("num nA\npoint pA\ntool tA\nmdesc mA\n{line}\nprogram other(point x_p)\nbegin\nend");
            assert_eq!(offered(&listing, ID).as_deref(), Some(&*format!("Create local variable `{wanted}`")), "{line}");
        }
    }

    #[test]
    fn the_local_is_declared() {
        check(
            ID,
            "program start()\n  num l_i\nbegin\n  l_$0j[1,2]=l_i\nend",
            expect![[r#"
            usrapp/main/start.pgx
            +      <Local name="l_j" type="num" xsi:type="array" size="2 3" />
        "#]],
        );
        check(
            ID,
            "l_$0b=true",
            expect![[r#"
            usrapp/main/start.pgx
            +    <Locals>
            +      <Local name="l_b" type="bool" xsi:type="array" size="1" />
            +    </Locals>
        "#]],
        );
    }

    #[test]
    fn known_names_and_programs_are_left_alone() {
        for line in ["n$0A=1", "pA.tr$0sf=pA.trsf", "call mi$0ssing()", "unkn$0own(1)", "part:n$0B=1"] {
            assert_eq!(offered(&format!("num nA\npoint pA\n{line}"), ID), None, "{line}");
        }
    }

    #[test]
    fn programs_of_s6_get_a_local() {
        check(
            ID,
            "num nZ\n=== main/start.pgx\n<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"start\" public=\"false\">\n    <paramSection/>\n    <localSection/>\n    <source><code>begin\n  l_n$0A=1&lt;2\nend</code></source>\n  </program>\n</programList>\n",
            expect![[r#"
                usrapp/main/start.pgx
                -    <localSection/>
                +    <localSection>
                +      <local name="l_nA" type="bool" size="1" />
                +    </localSection>
            "#]],
        );
    }
}
