//! V0402: global data without a reference that is used as if it had one.

use rustc_hash::FxHashSet;
use val3_analysis::body::ExprId;
use val3_analysis::items::declarations;
use val3_lang::builtins;
use val3_lang::data_path::DataPath;
use val3_lang::types::BaseType;

use super::no_reference::{error_of, needed};
use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program uses a global point, frame or tool that has no father in its data file and is never linked.
    ///
    /// ## Why
    /// An instruction that computes or moves with it stops the task with run-time error 162, 163 or 164. The father is
    /// easily lost in files that a tool wrote or a person merged.
    ///
    /// ## Bad
    /// ```val3
    /// movej(pPark,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pPark" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" z="700" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// movej(pPark,flange,mFast)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1" />
    ///     <Data name="pPark" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" z="700" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0402 "data-without-reference" Warning, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut told = FxHashSet::default();
    for call in program.calls() {
        let mut has_failed = false;
        for (arg, ty) in needed(call).filter(|(arg, ty)| lacks_father(program, *arg, *ty)) {
            let name = program.text(arg);
            let wording = word(name, ty, call.instruction.name, std::mem::replace(&mut has_failed, true));
            if !told.insert(name) {
                continue;
            }
            let reported = found.report(&RULE, program.range(arg), wording);
            let data = DataPath::new(name).before_index();
            let item = program.items.data.get(data);
            if let Some(place) = item.and_then(|item| declarations::data(program.db, item.file, data.into())) {
                reported.related_in(place, "its data names no father");
            }
        }
    }
}

/// Whether the argument is a value of global data that has no father in its file and gets none in a program.
fn lacks_father(program: &ProgramView<'_>, argument: ExprId, ty: BaseType) -> bool {
    let data = DataPath::new(program.text(argument)).before_index();
    !is_built_in(data, ty) && program.initial(argument).is_some_and(|initial| !initial.has_father)
}

/// Whether the data is `world` or `flange`, which files of s5 and s6 declare. They are the last fathers of all frames
/// and tools.
fn is_built_in(data: &str, ty: BaseType) -> bool {
    builtins::find(data).is_some_and(|builtin| builtin.is_variable && builtin.ty == ty)
}

fn word(name: &str, ty: BaseType, instruction: &str, has_failed: bool) -> Wording {
    let error = error_of(ty, has_failed);
    Wording::new(
        format!("the {} `{name}` that `{instruction}` uses has no father in its data file{error}", ty.name()),
        "no reference",
        "name its father in the data file (`fatherId`), or `link` it before it is used",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn listing(code: &str) -> String {
        format!(
            "{code}\n\n=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
             xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
             xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    \
             <Data name=\"pX\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"3\">\n      \
             <Value key=\"0\" x=\"1\" fatherId=\"world[0]\" />\n      <Value key=\"1\" x=\"1\" fatherId=\"\" />\n    \
             </Data>\n    <Data name=\"tX\" access=\"private\" xsi:type=\"array\" type=\"tool\" size=\"1\">\n      \
             <Value key=\"0\" z=\"9\" />\n    </Data>\n    \
             <Data name=\"mX\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\" />\n  \
             </Datas>\n</Database>\n"
        )
    }

    #[test]
    fn data_without_father_are_reported() {
        expect![[r#"
            start.pgx:5 `pX[1]` the point `pX[1]` that `movel` uses has no father in its data file (run-time error 162)
              | no reference
              ? name its father in the data file (`fatherId`), or `link` it before it is used
              > main.dtx:4 `pX` its data names no father
            start.pgx:5 `tX` the tool `tX` that `movel` uses has no father in its data file
              | no reference
              ? name its father in the data file (`fatherId`), or `link` it before it is used
              > main.dtx:8 `tX` its data names no father
        "#]]
        .assert_eq(&check(&RULE, &listing("movel(pX[1],tX,mX)\nmovel(pX[0],tX,mX)")));
    }

    #[test]
    fn data_with_a_reference_are_not_reported() {
        let lines = ["link(pX[1],world)\nmovel(pX[1],flange,mX)", "pX[1]=pX[0]\nmovel(pX[1],flange,mX)"];
        for line in lines.into_iter().chain(["movel(pX[0],flange,mX)", "movel(pX[2],flange,mX)", "put(pX[1].trsf.x)"]) {
            assert_eq!(check(&RULE, &listing(line)), "", "{line}");
        }
    }

    fn old_point(father: &str) -> String {
        format!(
            "movel(pX,flange,mX)\n\n=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<dataList \
             xmlns=\"DataNameSpace\">\n  <mdescSection>\n    <mdesc name=\"mX\" public=\"false\" />\n  \
             </mdescSection>\n  <pointSection>\n    <point name=\"pX\" public=\"false\">\n      \
             <pFather alias=\"\" name=\"{father}\" fatherIndex=\"0\" />\n      <valuePoint index=\"0\">\n        \
             <tpValue x=\"1\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\" />\n      </valuePoint>\n    \
             </point>\n  </pointSection>\n</dataList>\n"
        )
    }

    #[test]
    fn fathers_of_the_old_dialect_are_read() {
        expect![[r#"
            start.pgx:5 `pX` the point `pX` that `movel` uses has no father in its data file (run-time error 162)
              | no reference
              ? name its father in the data file (`fatherId`), or `link` it before it is used
              > main.dtx:7 `pX` its data names no father
        "#]]
        .assert_eq(&check(&RULE, &old_point("")));
        assert_eq!(check(&RULE, &old_point("world")), "");
    }

    #[test]
    fn declared_world_and_flange_are_not_reported() {
        let declared = "=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<dataList \
             xmlns=\"ProjectSchema\">\n  <frameSection>\n    <frame name=\"world\" public=\"false\">\n      \
             <fFather alias=\"\" name=\"\" fatherIndex=\"0\" />\n      <valueFrame index=\"0\">\n        \
             <tfValue x=\"0\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\" />\n      </valueFrame>\n    </frame>\n  \
             </frameSection>\n  <toolSection>\n    <tool name=\"flange\" public=\"false\">\n      \
             <tFather alias=\"\" name=\"\" fatherIndex=\"0\" />\n      <valueTool index=\"0\">\n        \
             <ttValue x=\"0\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\" />\n      </valueTool>\n    </tool>\n    \
             <tool name=\"tFree\" public=\"false\">\n      <tFather alias=\"\" name=\"\" fatherIndex=\"0\" />\n      \
             <valueTool index=\"0\">\n        <ttValue x=\"0\" y=\"0\" z=\"9\" rx=\"0\" ry=\"0\" rz=\"0\" />\n      \
             </valueTool>\n    </tool>\n  </toolSection>\n</dataList>\n";
        let listing = |line: &str| format!("program start()\n  point l_p\nbegin\n{line}\nend\n\n{declared}");
        assert_eq!(check(&RULE, &listing("l_p=here(flange,world)\nl_p=here(flange,world[0])")), "");
        assert_ne!(check(&RULE, &listing("l_p=here(tFree,world)")), "");
    }
}
