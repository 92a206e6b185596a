//! V0344: data that a task writes field by field and another task reads completely.

use smol_str::SmolStr;
use val3_analysis::application::summary;
use val3_analysis::body::{Expr, ExprId};
use val3_analysis::db::FileRange;
use val3_analysis::effects::{Access, AccessKind, RootVariable};
use val3_lang::instructions::SET_MUTEX;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// One task writes the fields of data on several lines, and another reads the complete data.
    ///
    /// ## Why
    /// Tasks take turns between lines: the reader may get a position with the new x and the old y. Assign the whole
    /// value on one line, or let both tasks take a mutex with `setMutex` around these lines; then nothing is reported.
    /// The rule only examines tasks that programs create.
    ///
    /// ## Bad
    /// ```val3
    /// trsf trGoal
    ///
    /// program start()
    /// begin
    ///   taskCreate "camera",10,locate()
    ///   taskCreate "screen",10,show()
    /// end
    ///
    /// program locate()
    /// begin
    ///   trGoal.x=1
    ///   trGoal.y=2
    /// end
    ///
    /// program show()
    ///   trsf l_trGoal
    /// begin
    ///   l_trGoal=trGoal
    ///   putln(l_trGoal.x)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// trsf trGoal
    ///
    /// program start()
    /// begin
    ///   taskCreate "camera",10,locate()
    ///   taskCreate "screen",10,show()
    /// end
    ///
    /// program locate()
    /// begin
    ///   trGoal={1,2,0,0,0,0}
    /// end
    ///
    /// program show()
    ///   trsf l_trGoal
    /// begin
    ///   l_trGoal=trGoal
    ///   putln(l_trGoal.x)
    /// end
    /// ```
    V0344 "torn-data" Info, Member: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let application = program.application();
    let name = SmolStr::from(program.name());
    if application.takers_of_mutexes.contains(&name) {
        return;
    }
    for FieldWrites { data, first, second } in parts(program) {
        let users = application.users.get(&data).into_iter().flatten();
        let mut readers: Vec<&SmolStr> = users
            .filter(|(user, uses)| uses.read_whole && *user != name && !application.takers_of_mutexes.contains(user))
            .filter(|(user, _)| application.run_side_by_side(&name, user))
            .map(|(user, _)| user)
            .collect();
        readers.sort_unstable();
        if let Some(reader) = readers.first() {
            found
                .report(&RULE, program.range(second), word(&data, reader))
                .related(program.range(first), "the first of its fields is set here")
                .related_at(read_by(program, reader, &data), "the other task may read it here");
        }
    }
}

/// Data of which the program writes several fields, with the first two such lines.
struct FieldWrites {
    data: SmolStr,
    first: ExprId,
    second: ExprId,
}

fn parts(program: &ProgramView<'_>) -> Vec<FieldWrites> {
    let in_parts =
        summary(program.db, program.project, program.file).data.iter().filter(|(_, uses)| uses.written_in_parts);
    let mut found: Vec<FieldWrites> = in_parts.filter_map(|(name, _)| field_writes(program, name)).collect();
    found.sort_by_key(|parts| program.range(parts.second).start());
    found
}

fn field_writes(program: &ProgramView<'_>, name: &SmolStr) -> Option<FieldWrites> {
    let writes = program.effects.all().iter().filter(|access| access.kind == AccessKind::WritePart);
    let mut writes = writes.filter(|access| is_of_data(access, name)).map(|access| access.id);
    Some(FieldWrites { data: name.clone(), first: writes.next()?, second: writes.next()? })
}

fn is_of_data(access: &Access, name: &SmolStr) -> bool {
    matches!(&access.root, RootVariable::Data(data) if data == name)
}

/// Location at which the program `reader` reads all of `data`.
fn read_by(program: &ProgramView<'_>, reader: &str, data: &SmolStr) -> Option<FileRange> {
    let reader = program.other(reader)?;
    let reads =
        reader.effects.all().iter().filter(|access| access.kind == AccessKind::Read && is_of_data(access, data));
    let mut reads = reads.map(|access| access.id);
    let whole = reads.find(|read| !matches!(reader.body.expr(*read), Expr::Field { .. }))?;
    Some(reader.span(whole))
}

fn word(data: &str, reader: &str) -> Wording {
    Wording::new(
        format!("a task that runs `{reader}` may read `{data}` when only some of its fields are new"),
        "the other task may run between these lines",
        format!("assign the whole value on one line, or take a mutex with `{SET_MUTEX}` in both tasks"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    const TASKS: &str = "trsf trA\ntrsf trB\nbool bA\ntaskCreate \"a\",10,p()\ntaskCreate \"b\",10,q()\n";

    fn tasks(writer: &str, reader: &str) -> String {
        let programs = format!("program p()\nbegin\n{writer}\nend\nprogram q()\nbegin\n{reader}\nend");
        check(&RULE, &format!("{TASKS}{programs}"))
    }

    #[test]
    fn fields_written_on_several_lines_are_reported() {
        expect![[r#"
            p.pgx:6 `trA.y` a task that runs `q` may read `trA` when only some of its fields are new
              | the other task may run between these lines
              ? assign the whole value on one line, or take a mutex with `setMutex` in both tasks
              > p.pgx:5 `trA.x` the first of its fields is set here
              > q.pgx:5 `trA` the other task may read it here
        "#]]
        .assert_eq(&tasks("trA.x=1\ntrA.y=2\ntrA.z=3", "trB=trA"));
    }

    #[test]
    fn one_line_one_field_and_locks_are_not_reported() {
        assert_eq!(tasks("trA.x=1", "trB=trA"), "");
        assert_eq!(tasks("trA={1,2,3,0,0,0}", "trB=trA"), "");
        assert_eq!(tasks("trA.x=1\ntrA.y=2", "?trA.x"), "");
        assert_eq!(tasks("setMutex(bA)\ntrA.x=1\ntrA.y=2\nbA=false", "trB=trA"), "");
    }

    #[test]
    fn data_of_one_task_are_not_reported() {
        let one = "taskCreate \"a\",10,p()\nprogram p()\nbegin\ntrA.x=1\ntrA.y=2\ncall q()\nend\n";
        assert_eq!(check(&RULE, &format!("trsf trA\ntrsf trB\n{one}program q()\nbegin\ntrB=trA\nend")), "");
        let start = "trA.x=1\ntrA.y=2\ntaskCreate \"a\",10,q()\n";
        assert_eq!(check(&RULE, &format!("trsf trA\ntrsf trB\n{start}program q()\nbegin\ntrB=trA\nend")), "");
    }
}
