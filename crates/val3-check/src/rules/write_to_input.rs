//! V0247: an input that a program writes.

use val3_analysis::body::ExprId;
use val3_analysis::effects::RootVariable;
use val3_analysis::flow::PointKind;
use val3_analysis::items::input_links::input_links;
use val3_lang::instructions::{AIO_SET, DIO_SET, ON_GRIPPERS};
use val3_lang::runtime_errors::WRITE_TO_INPUT;
use val3_lang::types::BaseType;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// A program writes data that its file links to an input, or opens or closes a tool whose output is an input.
    ///
    /// ## Why
    /// Inputs can only be read: run-time error 122 (3.5.2, 9.5.4). Addresses of inputs begin with `%I`, `usrIn` or `fIn`.
    /// Data that a program may link to something else is not reported.
    ///
    /// ## Bad
    /// ```val3
    /// dValve=true
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="dValve" access="private" xsi:type="array" type="dio" size="1">
    ///       <Value key="0" link="BasicIO-1\%I0" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dValve=true
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="dValve" access="private" xsi:type="array" type="dio" size="1">
    ///       <Value key="0" link="BasicIO-1\%Q0" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0247 "write-to-input" Error, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (_, point) in program.flow().points() {
        if let PointKind::Assign { target, .. } = point.kind
            && matches!(program.inference.ty(target).base.builtin(), Some(BaseType::Dio | BaseType::Aio))
        {
            report(program, target, false, found);
        }
    }
    for call in program.calls() {
        let is_tool = ON_GRIPPERS.contains(&call.instruction.name);
        if let Some(data) = call.args.first().filter(|_| is_tool || WRITERS.contains(&call.instruction.name)) {
            report(program, *data, is_tool, found);
        }
    }
}

/// Instructions that write their first argument.
const WRITERS: [&str; 2] = [DIO_SET, AIO_SET];

fn report(program: &ProgramView<'_>, data: ExprId, is_tool: bool, found: &mut Findings) {
    let Some(RootVariable::Data(name)) = program.effects.root(data) else { return };
    let Some(item) = program.items.data.get(&name) else { return };
    let Some(link) = input_links(program.db, item.file).get(&name) else { return };
    let application = program.application();
    // Data passed by reference, and public items, may have another link.
    let uses = application.uses_of(&name);
    let is_relinked = item.decl.public || !application.sound || uses.referenced || is_tool && uses.written;
    if !is_relinked {
        found
            .report(&RULE, program.range(data), word(program.text(data), link, is_tool))
            .related_at(program.declaration(data), "linked here");
    }
}

fn word(data: &str, link: &str, is_tool: bool) -> Wording {
    let message = if is_tool {
        format!("the output of the tool `{data}` is the input `{link}`")
    } else {
        format!("`{data}` is linked to the input `{link}`, which cannot be written")
    };
    Wording::new(message, runtime_error(WRITE_TO_INPUT), "link it to an output, or write another variable")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn cell(code: &str) -> String {
        let data = [
            r#"<Data name="dIn" access="private" xsi:type="array" type="dio" size="2"><Value key="0" link="BasicIO-1\%I0" /><Value key="1" link="BasicIO-1\%I1" /></Data>"#,
            r#"<Data name="dMixed" access="private" xsi:type="array" type="dio" size="2"><Value key="0" link="BasicIO-1\%I0" /><Value key="1" link="BasicIO-1\%Q1" /></Data>"#,
            r#"<Data name="dOut" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="BasicIO-1\%Q0" /></Data>"#,
            r#"<Data name="dPublic" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="BasicIO-1\%I0" /></Data>"#,
            r#"<Data name="tIn" access="private" xsi:type="array" type="tool" size="1"><Value key="0" fatherId="flange[0]" ioLink="BasicIO-1\%I0" /></Data>"#,
            r#"<Data name="tOut" access="private" xsi:type="array" type="tool" size="1"><Value key="0" fatherId="flange[0]" ioLink="valve1" /></Data>"#,
        ];
        let data = data.join("");
        check(&RULE, &format!("{code}\n=== main/main.dtx\n<Database><Datas>{data}</Datas></Database>"))
    }

    #[test]
    fn written_inputs_are_reported() {
        expect![[r#"
            start.pgx:5 `dIn[1]` `dIn[1]` is linked to the input `BasicIO-1\%I0`, which cannot be written
              | run-time error 122: write to an input
              ? link it to an output, or write another variable
              > main.dtx:1 `dIn` linked here
            start.pgx:6 `tIn` the output of the tool `tIn` is the input `BasicIO-1\%I0`
              | run-time error 122: write to an input
              ? link it to an output, or write another variable
              > main.dtx:1 `tIn` linked here
        "#]]
        .assert_eq(&cell("dIn[1]=true\nclose(tIn)"));
    }

    #[test]
    fn outputs_and_data_with_other_links_are_not_reported() {
        assert_eq!(cell("dOut=true\ndMixed[0]=true\ndPublic=true\nopen(tOut)\nif dIn\nputln(1)\nendIf"), "");
        assert_eq!(cell("dioLink(dIn,dOut)\ndIn=true"), "");
    }
}
