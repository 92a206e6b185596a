//! New programs: their files, and their elements in the `.pjx`.

use camino::Utf8Path;
use val3_analysis::db::{Db, Project};
use val3_analysis::items::declarations;
use val3_analysis::items::project::{folder, items};

use super::{NewVariable, PARAMETERS, free, local_entry, parameter_entry, program_entries};
use crate::edit::SourceChange;
use crate::xml_list::escaped;

/// A new program.
#[derive(Debug, Clone, Default)]
pub(crate) struct NewProgram {
    pub(crate) name: String,
    pub(crate) public: bool,
    /// Parameters, each with whether it is passed by reference.
    pub(crate) params: Vec<(NewVariable, bool)>,
    pub(crate) locals: Vec<NewVariable>,
    /// Lines between `begin` and `end`, unescaped, with indentation.
    pub(crate) code: Vec<String>,
    /// Line end.
    pub(crate) line_end: &'static str,
}

/// Creates programs in a project: their files, and their elements in the `.pjx`. `None` if the `.pjx` has no suitable
/// element.
pub(crate) fn programs(db: &dyn Db, project: Project, new: &[NewProgram]) -> Option<SourceChange> {
    let old = declarations::is_old(db, project);
    let files = new.iter().map(|new| {
        let path = folder(db, project).join(&new.name).with_extension("pgx");
        (path, if old { old_program(new) } else { new_program(new) })
    });
    let names: Vec<String> = new.iter().map(|new| format!("{}.pgx", new.name)).collect();
    let entries = program_entries(db, project, &names)?;
    Some(SourceChange { creates: files.collect(), ..SourceChange::of([entries]) })
}

fn new_program(new: &NewProgram) -> String {
    let access = if new.public { " access=\"public\"" } else { "" };
    let mut lines = vec![
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>".to_owned(),
        "<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">".to_owned(),
        format!("  <Program name=\"{}\"{access}>", new.name),
    ];
    if !new.params.is_empty() {
        lines.push(format!("    <Parameters{PARAMETERS}>"));
        let entry = |(variable, by_reference): &(NewVariable, bool)| parameter_entry(false, variable, *by_reference);
        lines.extend(new.params.iter().map(|param| format!("      {}", entry(param))));
        lines.push("    </Parameters>".to_owned());
    }
    if !new.locals.is_empty() {
        lines.push("    <Locals>".to_owned());
        lines.extend(new.locals.iter().map(|local| format!("      {}", local_entry(false, local))));
        lines.push("    </Locals>".to_owned());
    }
    lines.extend(code(&new.code));
    lines.extend(["  </Program>", "</Programs>", ""].map(str::to_owned));
    lines.join(new.line_end)
}

/// `Code` element with these lines: as a CDATA section, or escaped if a line contains `]]>`.
fn code(lines: &[String]) -> Vec<String> {
    let is_escaped = lines.iter().any(|line| line.contains("]]>"));
    let (open, close) = if is_escaped { ("", "") } else { ("<![CDATA[", "]]>") };
    let line = |line: &String| if is_escaped { escaped(line) } else { line.clone() };
    let mut code = vec![format!("    <Code>{open}begin")];
    code.extend(lines.iter().map(line));
    code.push(format!("end{close}</Code>"));
    code
}

fn old_program(new: &NewProgram) -> String {
    let mut lines = vec![
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>".to_owned(),
        "<programList xmlns=\"ProgramNameSpace\" >".to_owned(),
        format!("  <program name=\"{}\" public=\"{}\" >", new.name, new.public),
        "    <description></description>".to_owned(),
        "    <paramSection>".to_owned(),
    ];
    let entry = |(variable, by_reference): &(NewVariable, bool)| parameter_entry(true, variable, *by_reference);
    lines.extend(new.params.iter().map(|param| format!("      {}", entry(param))));
    lines.extend(["    </paramSection>", "    <localSection>"].map(str::to_owned));
    lines.extend(new.locals.iter().map(|local| format!("      {}", local_entry(true, local))));
    lines.extend(["    </localSection>", "    <source>", "      <code>begin"].map(str::to_owned));
    lines.extend(new.code.iter().map(|line| escaped(line)));
    lines.extend(["end</code>", "    </source>", "  </program>", "</programList>", ""].map(str::to_owned));
    lines.join(new.line_end)
}

/// A name that is unused among the project's programs and files: `stem`, otherwise `stem2` and so on.
pub(crate) fn free_program_name(db: &dyn Db, project: Project, stem: &str) -> String {
    free(stem, |name| has_program_or_file(db, project, name))
}

/// Whether a program, or a file in the project's folder, has this name in any letter case.
fn has_program_or_file(db: &dyn Db, project: Project, name: &str) -> bool {
    let same = |other: &str| other.eq_ignore_ascii_case(name);
    items(db, project).programs.keys().any(|other| same(other))
        || project.beside(db).iter().any(|file| Utf8Path::new(file.as_str()).file_stem().is_some_and(same))
}
