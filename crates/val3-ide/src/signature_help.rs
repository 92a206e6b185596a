//! Signature help: the parameters of the call at the cursor, with the best matching form, literal fields, and array
//! indexes.

mod brackets;

use val3_analysis::db::Db;
use val3_analysis::items::parse;
use val3_analysis::ty::{Base, Ty, brackets};
use val3_lang::instruction::{Instruction, Overload};
use val3_lang::{instructions, page};

use crate::FilePosition;
use crate::hover::program_comment;
use crate::line::{CallSite, Callee, LineTokens, VisibleNames};
use crate::owner::owner;

/// Forms of a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SignatureHelp {
    /// All forms.
    pub forms: Vec<CallForm>,
    /// Index of the form that matches the existing arguments.
    pub active_form: usize,
    /// Index of the argument at the cursor.
    pub active_parameter: usize,
}

/// One form of a call.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CallForm {
    /// Signature line, for example `num movej(joint jPosition, tool tTool, mdesc mDesc)`.
    pub line: String,
    /// Parameter ranges in the line, in bytes.
    pub parameters: Vec<(u32, u32)>,
    /// A sentence about the form.
    pub documentation: String,
}

/// Signature help at a position.
pub fn signature_help(db: &dyn Db, at: FilePosition) -> Option<SignatureHelp> {
    let project = owner(db, at.file)?;
    let line = LineTokens::around(&parse(db, at.file).root(), at.offset)?;
    let names = VisibleNames::new(db, project, at.file);
    if let Some(help) = brackets::help(&names, &line) {
        return Some(help);
    }
    let call = CallSite::around(&line)?;
    let active_parameter = call.active;
    if let Some(found) = instructions::find(&call.callee.name).filter(|_| !call.callee.is_program) {
        let types: Vec<Ty> = call.arguments.iter().map(|argument| names.ty(argument)).collect();
        let forms = found.overloads.iter().filter(|form| suits_place(form, found, &call.callee));
        let forms: Vec<&Overload> = forms.collect();
        let active_form = best_form(&forms, &types, active_parameter);
        let forms = forms.into_iter().map(|form| instruction_form(found, form)).collect();
        return Some(SignatureHelp { forms, active_form, active_parameter });
    }
    Some(SignatureHelp { forms: vec![program(&names, &call.callee)?], active_form: 0, active_parameter })
}

/// Whether the form suits a call with or without a library identifier. If an instruction has no suitable form, all
/// forms suit.
fn suits_place(form: &Overload, found: &Instruction, callee: &Callee) -> bool {
    let on_library = callee.library.is_some();
    form.on_library == on_library || found.overloads.iter().all(|form| form.on_library != on_library)
}

fn instruction_form(found: &Instruction, form: &Overload) -> CallForm {
    let line = form.signature(found.name);
    let params = form.params.iter().map(ToString::to_string);
    CallForm { parameters: places(&line, params), documentation: page::summary(found.page), line }
}

/// Ranges of the parameters in a line, in order.
fn places(line: &str, params: impl Iterator<Item = String>) -> Vec<(u32, u32)> {
    let mut from = line.find(['(', ' ']).map_or(0, |at| at + 1);
    let places = params.map_while(|param| {
        let start = from + line.get(from..)?.find(&param)?;
        from = start + param.len();
        Some((u32::try_from(start).ok()?, u32::try_from(from).ok()?))
    });
    places.collect()
}

/// Index of the form with enough parameters and the most matching argument types.
fn best_form(forms: &[&Overload], types: &[Ty], active: usize) -> usize {
    let by_rank = forms.iter().enumerate().rev().max_by_key(|(_, form)| {
        let len = form.params.len();
        (len > active, len >= types.len(), matching_types(form, types))
    });
    // If several forms are equally suitable, the first one is used.
    by_rank.map_or(0, |(index, _)| index)
}

/// Number of arguments that have their parameter's type.
fn matching_types(form: &Overload, types: &[Ty]) -> usize {
    let matching = form.params.iter().zip(types).filter(|(param, ty)| match (param.ty, ty.base) {
        (None, _) | (_, Base::Unknown) => false,
        (Some(wanted), base) => base.same_as(Base::of(wanted)),
    });
    matching.count()
}

/// Program of a callee.
fn program(names: &VisibleNames<'_>, callee: &Callee) -> Option<CallForm> {
    let signature = names.signature(callee)?;
    let params: Vec<String> = signature
        .params
        .iter()
        .map(|param| {
            let reference = if param.by_reference { "&" } else { "" };
            format!("{}{reference} {}{}", param.base.display(names.db), param.name, brackets(param.container))
        })
        .collect();
    let line = format!("{}({})", signature.name, params.join(", "));
    let documentation = names.program(callee).and_then(|(_, file)| program_comment(names.db, file)).unwrap_or_default();
    Some(CallForm { parameters: places(&line, params.into_iter()), line, documentation })
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::MarkedListing;

    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let shown = signature_help(marked.db(), marked.at()).map_or_else(String::new, |help| {
            let mut shown = String::new();
            for (index, form) in help.forms.iter().enumerate() {
                let mark = if index == help.active_form { "> " } else { "  " };
                let parameter = form.parameters.get(help.active_parameter);
                let parameter = parameter.map_or("", |(from, to)| &form.line[*from as usize..*to as usize]);
                shown += format!("{mark}{} | {parameter}", form.line).trim_end();
                shown.push('\n');
            }
            shown
        });
        expected.assert_eq(&shown);
    }

    #[test]
    fn instructions_show_their_forms() {
        check(
            "num nA\nnA=power(2,$0)",
            expect![[r#"
            > num power(num nX, num nY) | num nY
        "#]],
        );
        check(
            "point pA\ntool tA\nmdesc mA\nmovej(pA,$0tA,mA)",
            expect![[r#"
              num movej(joint jPosition, tool tTool, mdesc mDesc) | tool tTool
            > num movej(point pPosition, tool tTool, mdesc mDesc) | tool tTool
        "#]],
        );
        check(
            "num nA\nnA=power(sqrt($0),1)",
            expect![[r#"
            > num sqrt(num nValue) | num nValue
        "#]],
        );
        check(
            "num nA\nnA=power($0",
            expect![[r#"
            > num power(num nX, num nY) | num nX
        "#]],
        );
        check("num nA\nnA=power(2,3)$0", expect![[r#""#]]);
    }

    #[test]
    fn programs_show_their_parameters() {
        check(
            "call pick(1,$0)\nprogram pick(num x_n, string& x_s, num& x_g[,])\nbegin\nend",
            expect![[r#"
            > pick(num x_n, string& x_s, num& x_g[,]) | string& x_s
        "#]],
        );
    }

    #[test]
    fn task_creations_show_their_parameters() {
        check(
            "taskCreate \"a\",$0",
            expect![[r#"
            > taskCreate string sName, num nPriority, program(...) | num nPriority
        "#]],
        );
        check(
            "taskCreate \"a\",10,pick(1,$0)\nprogram pick(num x_n, string x_s)\nbegin\nend",
            expect![[r#"
            > pick(num x_n, string x_s) | string x_s
        "#]],
        );
    }

    #[test]
    fn programs_of_libraries_show_their_parameters() {
        let library = "library part \"Disk://part/part.pjx\"\n";
        let part = "\n--- part\npublic program pick(num x_n, bool& x_b)\nbegin\n  // Takes it.\nend";
        check(
            &format!("{library}call part:pick(1,$0{part}"),
            expect![[r#"
            > pick(num x_n, bool& x_b) | bool& x_b
        "#]],
        );
        check(
            &format!("{library}part:libLoad($0{part}"),
            expect![[r#"
            > num library:libLoad(string sPath) | string sPath
              num library:libLoad(string sPath, string sPassword) | string sPath
        "#]],
        );
        check(
            &format!("{library}libSave($0{part}"),
            expect![[r#"
                  num libSave() |
                > num libSave(string sPath) | string sPath
            "#]],
        );
    }

    #[test]
    fn incomplete_lines_have_signatures() {
        check(
            "point pA\nif pA. == sin($0\nelse\ncls()",
            expect![[r#"
            > num sin(num nAngle) | num nAngle
        "#]],
        );
        check(
            "num nA\nnA = = power(nA[1,2],$0",
            expect![[r#"
            > num power(num nX, num nY) | num nY
        "#]],
        );
        check(
            "num nA\nnA=max((1+2)*3,min({1,2},$0",
            expect![[r#"
            > num min(num nX, num nY) | num nY
        "#]],
        );
        check(
            "putln(\"a,(b\",$0",
            expect![[r#"
                  void putln(string sText) |
                > void putln(screen scPage, string sText) | string sText
                  void putln(num nValue) |
                  void putln(screen scPage, num nValue) | num nValue
            "#]],
        );
        check("num nA\nnA=power(1,\n$0cls()", expect![[""]]);
        check("cls()\n// power($0\ncls()", expect![[""]]);
    }

    #[test]
    fn braces_show_their_fields() {
        check(
            "trsf trA\ntrA={1,$0",
            expect![[r#"
            > trsf {num x, num y, num z, num rx, num ry, num rz} | num y
        "#]],
        );
        check(
            "tool tA\npoint pA\nmovej(pA,tA,{10,20,30,$0})",
            expect![[r#"
            > mdesc {num accel, num vel, num decel, num tvel, num rvel, blend blend, num leave, num reach} | num tvel
        "#]],
        );
        check(
            "point pA\npA={{1,2,3,$0",
            expect![[r#"
            > trsf {num x, num y, num z, num rx, num ry, num rz} | num rx
        "#]],
        );
        check(
            "tool tA\nmdesc mA\nmovej({0,0,$0},tA,mA)",
            expect![[r#"
            > joint {num j1, num j2, num j3, num j4, num j5, num j6} | num j3
              point {trsf trsf, config config} |
        "#]],
        );
        check("num nA\nnA={1,$0", expect![[""]]);
    }

    #[test]
    fn indexes_show_sizes_and_keys() {
        check(
            "num nGrid[3,4]\nnGrid[1,$0",
            expect![[r#"
            > num nGrid[0..2, 0..3] | 0..3
        "#]],
        );
        check(
            "num nA\nnA[$0]=1",
            expect![[r#"
            > num nA[0] | 0
        "#]],
        );
        check(
            "dio dIn[\"door\",\"lamp\"]\nwait(dIn[$0",
            expect![[r#"
            > dio dIn[key] | key
        "#]],
        );
        check(
            "program start(num& x_n[], num& x_g[,])\nbegin\n  x_g[$0]=x_n[1]\nend",
            expect![[r#"
            > num x_g[index 1, index 2] | index 1
        "#]],
        );
        check(
            "type Slot \"Disk://Slot/Slot.pjx\"\nprivate Slot sA[2]\nsA[1].nHeight[$0\n--- Slot\npublic num nHeight[5]",
            expect![[r#"
            > num nHeight[0..4] | 0..4
        "#]],
        );
        check(
            "library part \"Disk://part/part.pjx\"\nput(part:nAll[$0\n--- part\npublic num nAll[7]",
            expect![[r#"
            > num nAll[0..6] | 0..6
        "#]],
        );
        // If the index is unknown, the help shows the surrounding call.
        check(
            "put(nUnknown[$0",
            expect![[r#"
            > void put(string sText) | string sText
              void put(screen scPage, string sText) | screen scPage
              void put(num nValue) | num nValue
              void put(screen scPage, num nValue) | screen scPage
        "#]],
        );
    }
}
