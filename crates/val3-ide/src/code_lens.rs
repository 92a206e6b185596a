//! Code lenses of programs and declarations: reference counts, and commands to run and debug programs.

use val3_analysis::application::START;
use val3_analysis::db::{Db, File, FileRange, Project};
use val3_analysis::items::declarations;
use val3_analysis::items::program::{Header, header};
use val3_analysis::items::project::{data_files, program_files};
use val3_analysis::occurrences::Symbol;
use val3_syntax::{TextRange, text_at};

use crate::navigate::declaration;
use crate::owner::owner;
use crate::references::places;
use crate::test_programs::is_test;

/// A code lens of a declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CodeLens {
    /// Range of the declared name.
    pub range: TextRange,
    /// Kind.
    pub kind: LensKind,
}

/// Kind of a code lens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LensKind {
    /// Runs the program in the application of this `.pjx`.
    Run(File),
    /// Debugs the program in the application of this `.pjx`.
    Debug(File),
    /// Executes the program as a test, in the application of this `.pjx`.
    RunTest(File),
    /// Debugs the program as a test.
    DebugTest(File),
    /// Reference count of a program, computed later by [`lens_references`].
    ProgramReferences,
    /// Reference count of data.
    DataReferences,
}

/// Code lenses of a file, without reference counts, which require a search.
pub fn code_lenses(db: &dyn Db, file: File) -> Vec<CodeLens> {
    let Some(project) = owner(db, file) else { return Vec::new() };
    if program_files(db, project).contains(&file) {
        return of_program(db, project, file);
    }
    if !data_files(db, project).contains(&file) {
        return Vec::new();
    }
    let names = declarations::all_data(db, file);
    names.into_iter().map(|found| CodeLens { range: found.range, kind: LensKind::DataReferences }).collect()
}

fn of_program(db: &dyn Db, project: Project, file: File) -> Vec<CodeLens> {
    let header = header(db, file);
    let Some(place) = declarations::program(db, file) else { return Vec::new() };
    let lens = |kind| CodeLens { range: place.range, kind };
    let manifest = project.manifest(db);
    let mut lenses = Vec::new();
    if is_test(db, project, &header.name) {
        lenses.extend([lens(LensKind::RunTest(manifest)), lens(LensKind::DebugTest(manifest))]);
    }
    if runs_alone(header) {
        lenses.extend([lens(LensKind::Run(manifest)), lens(LensKind::Debug(manifest))]);
    }
    lenses.push(lens(LensKind::ProgramReferences));
    lenses
}

/// Whether the program can be started without a caller: it is `start`, or has no parameters.
pub(crate) fn runs_alone(header: &Header) -> bool {
    header.name == START || header.params.is_empty()
}

/// References to the declaration at the range of a lens with a count, sorted by path and offset.
pub fn lens_references(db: &dyn Db, at: FileRange) -> Vec<FileRange> {
    let Some(project) = owner(db, at.file) else { return Vec::new() };
    let name = text_at(at.file.text(db), at.range);
    let symbol = match program_files(db, project).contains(&at.file) {
        true => Symbol::Program(project, name.into()),
        false => Symbol::Data(project, name.into()),
    };
    if declaration(db, &symbol) != Some(at) {
        return Vec::new();
    }
    places(db, &symbol, false)
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::{MarkedListing, shown};

    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let (db, file) = (marked.db(), marked.at().file);
        let mut lines = String::new();
        for lens in code_lenses(db, file) {
            let place = FileRange { file, range: lens.range };
            lines += &format!("{}: {}\n", shown(db, place), title(db, lens.kind, place));
        }
        expected.assert_eq(&lines);
    }

    fn title(db: &dyn Db, kind: LensKind, place: FileRange) -> String {
        match kind {
            LensKind::Run(file) => format!("run {}", file.path(db).file_name().unwrap()),
            LensKind::Debug(file) => format!("debug {}", file.path(db).file_name().unwrap()),
            LensKind::RunTest(file) => format!("run test of {}", file.path(db).file_name().unwrap()),
            LensKind::DebugTest(file) => format!("debug test of {}", file.path(db).file_name().unwrap()),
            LensKind::ProgramReferences | LensKind::DataReferences => {
                format!("{} references", lens_references(db, place).len())
            }
        }
    }

    #[test]
    fn programs_show_their_uses() {
        check(
            "pu$0t(1)",
            expect![[r#"
            main/start.pgx:3 start: run main.pjx
            main/start.pgx:3 start: debug main.pjx
            main/start.pgx:3 start: 0 references
        "#]],
        );
        check(
            "call other()\ncall other()\nprogram other()\nbegin\n  call oth$0er()\nend",
            expect![[r#"
                main/other.pgx:3 other: run main.pjx
                main/other.pgx:3 other: debug main.pjx
                main/other.pgx:3 other: 3 references
            "#]],
        );
    }

    #[test]
    fn tests_can_be_executed() {
        check(
            "put(1)\n--- mainTest\nprogram testSum()\nbegin\n  wait(tr$0ue)\nend",
            expect![[r#"
                mainTest/testSum.pgx:3 testSum: run test of mainTest.pjx
                mainTest/testSum.pgx:3 testSum: debug test of mainTest.pjx
                mainTest/testSum.pgx:3 testSum: run mainTest.pjx
                mainTest/testSum.pgx:3 testSum: debug mainTest.pjx
                mainTest/testSum.pgx:3 testSum: 0 references
            "#]],
        );
        check(
            "put(1)\n--- mainTest\nprogram setup()\nbegin\n  wait(tr$0ue)\nend",
            expect![[r#"
            mainTest/setup.pgx:3 setup: run mainTest.pjx
            mainTest/setup.pgx:3 setup: debug mainTest.pjx
            mainTest/setup.pgx:3 setup: 0 references
        "#]],
        );
        check(
            "put(1)\nprogram testSum()\nbegin\n  wait(tr$0ue)\nend",
            expect![[r#"
            main/testSum.pgx:3 testSum: run main.pjx
            main/testSum.pgx:3 testSum: debug main.pjx
            main/testSum.pgx:3 testSum: 0 references
        "#]],
        );
    }

    #[test]
    fn data_show_their_uses() {
        let data = "<Database xmlns:xsi=\"i\"><Datas><Data name=\"n$0A\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n<Data name=\"nB\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" /></Datas></Database>";
        check(
            &format!("num nA\nnA=nA+1\n=== main/main.dtx\n{data}\n"),
            expect![[r#"
            main/main.dtx:1 nA: 2 references
            main/main.dtx:2 nB: 0 references
        "#]],
        );
    }
}
