//! Makes a program or data public, or private.

use val3_analysis::items::{data, program};
use val3_analysis::xml::Element;
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, TextRange};

use super::context::Context;
use super::{AssistKind, Assists};
use crate::edit::{FileEdit, SourceChange};

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let view = parse.view();
    let element = declaring(context, view)?;
    let is_old = !matches!(element.name(), "Program" | "Data");
    let attribute = element.attribute(if is_old { "public" } else { "access" });
    let yes = if is_old { "true" } else { "public" };
    let public = attribute.is_some_and(|found| found.text().trim() == yes);
    let title = if public { "Make private" } else { "Make public" };
    assists.add("toggle-access", AssistKind::Rewrite, title, || {
        let word = match (is_old, public) {
            (true, _) => {
                if public {
                    "false"
                } else {
                    "true"
                }
            }
            (false, _) => {
                if public {
                    "private"
                } else {
                    "public"
                }
            }
        };
        let edit = match attribute {
            Some(found) => context.replace(found.range, word),
            None => new_attribute(context, element, if is_old { "public" } else { "access" }, word)?,
        };
        Some(SourceChange::of([edit]))
    });
    Some(())
}

/// The program whose header the place is in, or the data whose start tag it is in.
fn declaring<'g>(context: &Context<'_>, view: View<'g>) -> Option<Element<'g>> {
    let at = context.range;
    let touches = |element: &Element<'_>| element.tag_range().contains_range(at);
    let program = program::element(view).filter(|program| touches(program) || is_at_begin(context));
    program.or_else(|| data::elements(view).find(touches))
}

/// The cursor is on the `begin` of the code: where the header is folded away, this is its place.
fn is_at_begin(context: &Context<'_>) -> bool {
    context.range.is_empty() && context.token().is_some_and(|token| token.kind() == SyntaxKind::BEGIN_KW)
}

fn new_attribute(context: &Context<'_>, element: Element<'_>, name: &str, value: &str) -> Option<FileEdit> {
    let at = element.attribute("name")?.range.end() + val3_syntax::TextSize::of('"');
    Some(context.replace(TextRange::empty(at), format!(" {name}=\"{value}\"")))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::assists::testing::{check, offered};

    const ID: &str = "toggle-access";

    fn program(attributes: &str) -> String {
        format!(
            "num nA\n=== main/other.pgx\n<Programs><Program name=\"other\"{attributes}><Code><![CDATA[beg$0in\n  put(1)\nend]]></Code></Program></Programs>\n"
        )
    }

    #[test]
    fn programs() {
        check(
            ID,
            &program(""),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other"><Code><![CDATA[begin
            +<Programs><Program name="other" access="public"><Code><![CDATA[begin
        "#]],
        );
        check(
            ID,
            &program(" access=\"public\""),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other" access="public"><Code><![CDATA[begin
            +<Programs><Program name="other" access="private"><Code><![CDATA[begin
        "#]],
        );
        check(
            ID,
            &program("").replace("$0", "").replace("name=", "na$0me="),
            expect![[r#"
            usrapp/main/other.pgx
            -<Programs><Program name="other"><Code><![CDATA[begin
            +<Programs><Program name="other" access="public"><Code><![CDATA[begin
        "#]],
        );
        assert_eq!(offered("program other()\nbegin\n  pu$0t(1)\nend", ID), None);
    }

    const DATA: &str = "num nZ\n=== main/main.dtx\n<Database xmlns:xsi=\"i\"><Datas><Data name=\"n$0A\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>\n";

    #[test]
    fn data() {
        check(
            ID,
            DATA,
            expect![[r#"
            usrapp/main/main.dtx
            -<Database xmlns:xsi="i"><Datas><Data name="nA" access="private" xsi:type="array" type="num" size="1" /></Datas></Database>
            +<Database xmlns:xsi="i"><Datas><Data name="nA" access="public" xsi:type="array" type="num" size="1" /></Datas></Database>
        "#]],
        );
        check(
            ID,
            "num nZ\n=== main/main.dtx\n<dataList><numSection><num name=\"n$0A\" public=\"true\"></num></numSection></dataList>\n",
            expect![[r#"
                usrapp/main/main.dtx
                -<dataList><numSection><num name="nA" public="true"></num></numSection></dataList>
                +<dataList><numSection><num name="nA" public="false"></num></numSection></dataList>
            "#]],
        );
    }
}
