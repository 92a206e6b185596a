//! Adds a comment about a program and its parameters at the start of the code, in the form that hover displays.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::effects::{AccessKind, Effects, RootVariable};
use val3_analysis::items::program;
use val3_analysis::items::project::signature;
use val3_analysis::ty::brackets;
use val3_syntax::{SyntaxKind, TextRange};

use super::context::Context;
use super::toggle_access::is_at_begin;
use super::{AssistKind, Assists};
use crate::edit::SourceChange;
use crate::hover::program_comment;

pub(super) fn offer(context: &Context<'_>, assists: &mut Assists<'_>) -> Option<()> {
    let parse = val3_analysis::items::parse(context.db, context.file);
    let view = parse.view();
    let is_in_tag = program::element(view)?.tag_range().contains_range(context.range);
    if !(is_in_tag || is_at_begin(context)) || program_comment(context.db, context.file).is_some() {
        return None;
    }
    let code = program::code(view)?;
    let begin = code.token(SyntaxKind::BEGIN_KW)?.range();
    let title = "Add a comment about the program and its parameters";
    assists.add("program-header", AssistKind::Rewrite, title, || {
        let (line_end, indent) = (context.line_end(), context.level());
        let line = |line: String| format!("{line_end}{indent}{}", context.written(&line));
        let comments = header_comments(context.db, context.project, context.file);
        let text: String = comments.into_iter().map(line).collect();
        Some(SourceChange::of([context.replace(TextRange::empty(begin.end()), text)]))
    });
    Some(())
}

/// Comments for a program and each parameter, for example `//\brief pick: purpose` and `//\param x_nSlot num, in`.
pub(crate) fn header_comments(db: &dyn Db, project: Project, file: File) -> Vec<String> {
    let signature = signature(db, project, file);
    let effects = Effects::new(db, project, file);
    let mut lines = vec![format!("//\\brief {}: purpose", signature.name)];
    for param in &signature.params {
        let ty = param.base.display(db);
        let direction = if param.by_reference { direction(&effects, &param.name) } else { "in" };
        lines.push(format!("//\\param {} {ty}{}, {direction}", param.name, brackets(param.container)));
    }
    lines
}

/// Direction of a parameter by reference (`in`, `out` or both), as far as the program's code shows it.
fn direction(effects: &Effects<'_>, name: &str) -> &'static str {
    let own = effects.all().iter().filter(|access| matches!(&access.root, RootVariable::Param(param) if param == name));
    let kinds: Vec<AccessKind> = own.map(|access| access.kind).collect();
    let reads = kinds.iter().any(|kind| matches!(kind, AccessKind::Read | AccessKind::Reference));
    let writes = kinds.iter().any(|kind| *kind != AccessKind::Read);
    match (reads, writes) {
        (true, false) => "in",
        (false, true) => "out",
        _ => "in and out",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use val3_analysis::db::FileRange;
    use val3_syntax::TextRange;

    use crate::assists::resolve_assist;
    use crate::assists::testing::{check, offered};
    use crate::hover::hover;
    use crate::testing::MarkedListing;

    const ID: &str = "program-header";

    const PICK: &str = "put(1)\n=== main/pick.pgx\n<Programs xmlns:xsi=\"i\"><Program name=\"pick\">\n<Parameters>\n\
        <Parameter name=\"x_nIn\" type=\"num\" xsi:type=\"element\" />\n\
        <Parameter name=\"x_nList\" type=\"num\" xsi:type=\"array\" use=\"reference\" />\n\
        <Parameter name=\"x_nOut\" type=\"num\" xsi:type=\"element\" use=\"reference\" />\n\
        <Parameter name=\"x_nBoth\" type=\"num\" xsi:type=\"element\" use=\"reference\" />\n</Parameters>\n\
        <Code><![CDATA[be$0gin\n  put(x_nIn+x_nList[0])\n  x_nOut=1\n  x_nBoth=x_nBoth+1\nend]]></Code></Program></Programs>";

    #[test]
    fn a_program_gets_a_comment_with_its_parameters() {
        check(
            ID,
            PICK,
            expect![[r#"
                usrapp/main/pick.pgx
                +  //\brief pick: purpose
                +  //\param x_nIn num, in
                +  //\param x_nList num[], in
                +  //\param x_nOut num, out
                +  //\param x_nBoth num, in and out
            "#]],
        );
    }

    #[test]
    fn hover_shows_the_comment() {
        let marked = MarkedListing::new(PICK);
        let place = FileRange { file: marked.at().file, range: TextRange::empty(marked.at().offset) };
        let change = resolve_assist(marked.db(), ID, place).unwrap();
        let mut text = place.file.text(marked.db()).to_string();
        text.insert_str(usize::from(change.edits[0].range.start()), &change.edits[0].text);
        let listing = PICK.split("===").next().unwrap();
        let commented =
            MarkedListing::new(&format!("{listing}=== main/pick.pgx\n{}", text.replacen("pick", "pi$0ck", 1)));
        expect![[r#"
            ```val3
            program pick(num x_nIn, num& x_nList[], num& x_nOut, num& x_nBoth)
            ```

            pick: purpose
            - `x_nIn`: num, in
            - `x_nList`: num\[], in
            - `x_nOut`: num, out
            - `x_nBoth`: num, in and out"#]]
        .assert_eq(&hover(commented.db(), commented.at()).unwrap().markdown);
    }

    #[test]
    fn escaped_code_with_other_line_ends_is_kept() {
        let program =
            "<Programs><Program na$0me=\"other\"><Code>begin&#13;\r\n\tput(1)&#13;\r\nend</Code></Program></Programs>";
        check(
            ID,
            &format!("put(1)\n=== main/other.pgx\n{program}"),
            expect![[r#"
                usrapp/main/other.pgx
                +  //\brief other: purpose&#13;
            "#]],
        );
    }

    #[test]
    fn programs_with_a_comment_or_a_description_are_not_offered() {
        assert_eq!(offered(&PICK.replace("gin\n", "gin\n// picks\n"), ID), None);
        let described = "put(1)\n=== main/other.pgx\n<Programs><Program na$0me=\"other\"><Description>picks</Description><Code><![CDATA[begin\nend]]></Code></Program></Programs>";
        assert_eq!(offered(described, ID), None);
        assert!(offered(&described.replace("picks", ""), ID).is_some());
        assert_eq!(offered("program start()\nbegin\n  p$0ut(1)\nend", ID), None);
    }
}
