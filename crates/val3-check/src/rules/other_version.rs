//! V0540: code that must be changed for another version.

use rustc_hash::FxHashSet;
use val3_analysis::body::{ExprId, StmtKind};
use val3_lang::replacements::{is_text_page, replacement};
use val3_lang::types::BaseType;
use val3_lang::versions::Version;

use super::instruction_version::{MissingFeature, lack};
use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::rule::{Severity, rule};

rule! {
    /// An instruction or operator does not exist, or has no effect, in the version to which the application is moved.
    ///
    /// ## Why
    /// `val3 check --for s8.10`, or `target-version` in the table `[lint]` of `val3.toml`, reports the changes that are
    /// required if the applications are moved to that version, for example from a CS8 (s5 to s7) to a CS9 (s8). The
    /// text page with `gotoxy` and `put` is not shown on a CS9: its user pages are HTML pages. Add-ons have to be
    /// installed for the new version. Each instruction is reported once per program. From s7 on, a `dio` is assigned a
    /// `bool` and no other `dio` (3.5.2).
    ///
    /// ## Bad
    /// ```val3
    /// version s7.11
    /// gotoxy(0,3)
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s8.10"
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s7.11
    /// logMsg("ready")
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s8.10"
    /// ```
    V0540 "other-version" Warning
}

/// Checks a program with or without faults.
pub(crate) fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(target) = program.options.target_version else { return };
    let mut told = FxHashSet::default();
    for call in program.calls() {
        if let Some((wording, level)) =
            fault(call, program.items.version, target).filter(|_| told.insert(call.instruction))
        {
            found.report(&RULE, program.range(call.callee), wording).level(level);
        }
    }
    if program.items.version.assigns_dio_to_dio() && !target.assigns_dio_to_dio() {
        check_assignments(program, target, found);
    }
}

/// Checks that no `dio` is assigned to a `dio`.
fn check_assignments(program: &ProgramView<'_>, version: Version, found: &mut Findings) {
    let is_dio = |id: ExprId| program.inference.ty(id).base.builtin() == Some(BaseType::Dio);
    for stmt in program.stmts() {
        let StmtKind::Assign { target, value } = stmt.kind else { continue };
        if is_dio(target) && is_dio(value) {
            let wording = word_assignment(program.text(target), program.text(value), version);
            found.report(&RULE, stmt.range, wording);
        }
    }
}

fn fault(call: &Call<'_>, declared: Version, target: Version) -> Option<(Wording, Severity)> {
    let name = call.instruction.name;
    if let Some(lack) = lack(*call, target) {
        return Some((word_lack(name, &lack, target), Severity::Warning));
    }
    if let Some(add_on) = call.instruction.add_on().filter(|_| declared.language() != target.language()) {
        return Some((word_add_on(name, add_on, target), Severity::Info));
    }
    let is_lost = is_text_page(name) && target.language() >= CS9 && declared.language() < CS9;
    is_lost.then(|| (word_page(name, target), Severity::Warning))
}

/// First number of CS9 versions.
const CS9: u8 = 8;

fn word_lack(name: &str, lack: &MissingFeature, target: Version) -> Wording {
    let what = if lack.is_form { format!("this form of `{name}`") } else { format!("`{name}`") };
    let advice = replacement(name).unwrap_or("use what that version has");
    Wording::new(format!("{what} does not exist in {target}"), format!("not in {target}"), advice)
}

fn word_add_on(name: &str, add_on: &str, target: Version) -> Wording {
    Wording::new(
        format!("`{name}` needs the add-on `{add_on}` for {target}"),
        "instruction of an add-on",
        "order and install the add-on for the new controller",
    )
}

fn word_page(name: &str, target: Version) -> Wording {
    let advice = replacement(name).unwrap_or("use an HTML user page");
    Wording::new(format!("`{name}` uses the text page, which {target} does not show"), "text page", advice)
}

fn word_assignment(output: &str, input: &str, target: Version) -> Wording {
    Wording::new(
        format!("a `dio` cannot be assigned to a `dio` in {target}"),
        format!("not in {target}"),
        format!("compare the input: `{output}=({input}==true)`"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn moved(from: &str, to: &str, code: &str) -> String {
        let settings = format!("=== val3.toml\n[lint]\ntarget-version = \"{to}\"");
        check(&RULE, &format!("version {from}\nnum nDone\n{code}\n{settings}"))
    }

    #[test]
    fn what_has_to_change_is_reported() {
        expect![[r#"
            start.pgx:5 `cls` `cls` uses the text page, which s8.10 does not show
              | text page
              ? an HTML user page shows data that are bound to its elements: nothing has to be cleared
            start.pgx:6 `put` `put` uses the text page, which s8.10 does not show
              | text page
              ? bind a variable to an element of an HTML user page; `popUpMsg` and `logMsg` show single messages
            start.pgx:8 `getKey` `getKey` uses the text page, which s8.10 does not show
              | text page
              ? bind a program to a button of an HTML user page
        "#]]
        .assert_eq(&moved("s7.11", "s8.10", "cls()\nput(1)\nput(2)\nnDone=getKey()\nnoProgram()"));
        expect![[r#"
            start.pgx:5 `opcuaExport` `opcuaExport` does not exist in s7.11
              | not in s7.11
              ? exchange the data by `sio` or a fieldbus
        "#]]
        .assert_eq(&moved("s8.10", "s7.11", "opcuaExport(nDone,false)"));
    }

    #[test]
    fn the_assignment_of_a_dio_to_a_dio_is_reported() {
        let code = "dio dIn\ndio dOut[2]\ndOut[1]=dIn\ndOut=(dIn==true)";
        expect![[r#"
            start.pgx:5 `dOut[1]=dIn` a `dio` cannot be assigned to a `dio` in s8.10
              | not in s8.10
              ? compare the input: `dOut[1]=(dIn==true)`
        "#]]
        .assert_eq(&moved("s6.8", "s8.10", code));
        assert_eq!(moved("s5.3", "s6.8", code), "");
    }

    #[test]
    fn what_both_versions_have_is_not_reported() {
        assert_eq!(moved("s7.11", "s8.10", "logMsg(\"a\")\nopcuaExport(nDone,false)"), "");
        assert_eq!(moved("s8.3", "s8.10", "cls()"), "");
        assert_eq!(check(&RULE, "version s7.11\ncls()"), "");
    }
}
