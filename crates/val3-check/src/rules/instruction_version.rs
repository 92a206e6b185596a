//! V0532: an instruction that the declared version or the controller of the cell does not have.

use rustc_hash::FxHashSet;
use val3_analysis::db::FileRange;
use val3_analysis::items::declarations;
use val3_lang::instruction::{Availability, Instruction};
use val3_lang::versions::Version;

use crate::diagnostic::Wording;
use crate::lint::{Call, Findings, ProgramView};
use crate::rule::{Severity, rule};

rule! {
    /// An instruction, or a form of one, does not exist in the version that the project declares.
    ///
    /// ## Why
    /// Controllers of that version do not load the program. Some instructions were added with the CS9 controller (s8),
    /// some were removed there. If the application only runs on newer controllers, declare their version in the `.pjx`.
    /// Each instruction is reported once per program.
    ///
    /// The version that a project declares is not always that of the controller: a CS9 (s8) runs projects that declare
    /// s7. So the finding is information, unless the files of the cell (`usr/configs/val3version.xml`) state a version
    /// without the instruction: then the controller rejects the program, and the finding is an error.
    ///
    /// ## Bad
    /// ```val3
    /// version s7.11
    /// num nDone
    /// opcuaExport(nDone,false)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s8.12
    /// num nDone
    /// opcuaExport(nDone,false)
    /// ```
    V0532 "instruction-version" Info
}

/// Checks a program with or without faults, because an older controller also rejects it because of the instruction.
pub(crate) fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let mut told = FxHashSet::default();
    let cell = program.project.cell(program.db).and_then(|cell| cell.config(program.db).version);
    let declared = declarations::version(program.db, program.project);
    let version = program.items.version;
    for call in program.calls() {
        let of_cell = cell.and_then(|version| Some((lack(*call, version)?, version)));
        if let Some((lack, version)) = of_cell.filter(|_| told.insert(call.instruction)) {
            let owner = format!("the controller of the cell has {version}");
            let wording = word(call.instruction, &lack, version, &owner);
            found.report(&RULE, program.range(call.callee), wording).level(Severity::Error);
        }
        let Some(declared) = declared else { continue };
        if let Some(lack) = lack(*call, version).filter(|_| told.insert(call.instruction)) {
            let manifest = FileRange { file: program.project.manifest(program.db), range: declared };
            let wording = word(call.instruction, &lack, version, &format!("the project declares {version}"));
            found.report(&RULE, program.range(call.callee), wording).related_in(manifest, "declared here");
        }
    }
}

/// An instruction or form that is missing in the version, and the versions that have it.
pub(super) struct MissingFeature {
    /// Whether only the form is missing.
    pub(super) is_form: bool,
    since: Option<u8>,
    until: Option<u8>,
}

/// Instruction, or form of it, that a version does not have for a call.
pub(super) fn lack(call: Call<'_>, version: Version) -> Option<MissingFeature> {
    match call.instruction.availability {
        Availability::Version { since, until } if !call.instruction.exists_in(version) => {
            Some(MissingFeature { is_form: false, since: Some(since).filter(|since| *since > 0), until })
        }
        _ => {
            let form = call.form.filter(|form| !form.exists_in(version))?;
            Some(MissingFeature { is_form: true, since: form.since, until: None })
        }
    }
}

/// Returns the wording of the finding. `owner` states whose version it is.
fn word(instruction: &Instruction, lack: &MissingFeature, version: Version, owner: &str) -> Wording {
    let name = instruction.name;
    let what = if lack.is_form { format!("this form of `{name}`") } else { format!("`{name}`") };
    let when = match (lack.since, lack.until) {
        (Some(since), _) if version.language() < since => format!("from s{since} on"),
        (_, Some(until)) => format!("up to s{until}"),
        _ => "in other versions".to_owned(),
    };
    Wording::new(
        format!("{what} exists {when}, and {owner}"),
        format!("not in {version}"),
        "use what this version has, or declare the version of the controllers that run it",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};

    fn export(version: &str) -> String {
        check(&RULE, &format!("version {version}\nnum nDone\nopcuaExport(nDone,false)\nopcuaExport(nDone,true)"))
    }

    #[test]
    fn instructions_newer_than_the_declared_version_are_reported() {
        expect![[r#"
            start.pgx:5 `opcuaExport` `opcuaExport` exists from s8 on, and the project declares s7.11.3
              | not in s7.11.3
              ? use what this version has, or declare the version of the controllers that run it
              > main.pjx:3 `s7.11.3` declared here
        "#]]
        .assert_eq(&export("s7.11.3"));
    }

    #[test]
    fn instructions_of_the_declared_version_are_not_reported() {
        assert_eq!(export("s8.3Cs9_BS845"), "");
        assert_eq!(check(&RULE, "version s6.8\ncls()"), "");
    }

    fn cell(declared: &str, version: &str) -> String {
        format!(
            "version {declared}\nnum nDone\nopcuaExport(nDone,false)\nnoProgram()\n=== /configs/val3version.xml\n\
             <Versions><Version name=\"val3\" compatibility=\"7\">{version}</Version></Versions>"
        )
    }

    #[test]
    fn the_version_of_the_controller_of_the_cell_is_decisive() {
        expect![[r#"
            start.pgx:5 `opcuaExport` `opcuaExport` exists from s8 on, and the controller of the cell has s7.8.3
              | not in s7.8.3
              ? use what this version has, or declare the version of the controllers that run it
        "#]]
        .assert_eq(&check(&RULE, &cell("s8.10", "s7.8.3")));
        assert_eq!(levels(&RULE, &cell("s7.8", "s7.8.3")), [Severity::Error]);
        assert_eq!(levels(&RULE, &cell("s7.8", "s8.10.2Cs9_BS1991")), [Severity::Info]);
        assert_eq!(levels(&RULE, &cell("s8.10", "s8.10.2Cs9_BS1991")), []);
        assert_eq!(levels(&RULE, &cell("s7.0.1Cs9", "s8.10.2Cs9_BS1991")), []);
    }
}
