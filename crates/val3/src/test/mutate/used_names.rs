//! Variables that a test uses: the variables named by its executed lines and its scenario, and their fathers.

use std::collections::{BTreeMap, BTreeSet};

use val3_analysis::db::{Database, Project, Sources};
use val3_analysis::items::program::code;
use val3_analysis::items::project::{data_files, items};
use val3_analysis::paths::path_key;
use val3_coverage::Coverage;
use val3_data::written;
use val3_files::FileClass;
use val3_lang::data_path::DataPath;
use val3_session::Application;
use val3_syntax::view::View;
use val3_syntax::{SyntaxKind, encoding, parse, xml};

use SyntaxKind::{COLON, DOT, IDENT};

/// Variable, by project file path and name.
type UsedVariable = (String, String);

/// Variables that a test uses.
#[derive(Debug, Clone, Default)]
pub(super) struct UsedNames {
    variables: BTreeSet<UsedVariable>,
    /// Field names of user types.
    fields: BTreeSet<String>,
}

/// Code token with its line, from 1.
struct CodeToken<'t> {
    kind: SyntaxKind,
    text: &'t str,
    line: u32,
}

impl UsedNames {
    /// Collects the variables named by executed lines and by a scenario with this text.
    pub(super) fn of(application: &Application, executed: &Coverage, scenario: Option<&str>) -> Self {
        let db = application.db();
        let mut used = Self::default();
        for (file, program) in executed.programs() {
            let project = Sources::get(db).projects(db).get(&path_key(&program.project_file)).copied();
            // Other programs exist only in the memory of the controller, where a test has written them.
            let (Some(project), Some(text)) = (project, text(file)) else { continue };
            let lines = program.lines.iter().filter(|(_, hits)| **hits > 0).map(|(line, _)| *line).collect();
            used.add_code(db, project, &text, &lines);
        }
        let separates = |character: char| !(character.is_ascii_alphanumeric() || matches!(character, '_' | ':'));
        for word in scenario.into_iter().flat_map(|text| text.split(separates)) {
            used.add(db, application.project(), word);
        }
        used.add_fathers(db);
        used
    }

    /// Whether the test uses a variable of the project with this file.
    pub(super) fn contains(&self, project_file: &str, name: &str) -> bool {
        self.variables.contains(&(project_file.to_owned(), name.to_owned()))
    }

    /// Whether the test uses a field with this name.
    pub(super) fn contains_field(&self, name: &str) -> bool {
        self.fields.contains(name)
    }

    fn add_code(&mut self, db: &Database, project: Project, text: &str, lines: &BTreeSet<u32>) {
        let parse = parse(text);
        let mut tokens = Vec::new();
        if let Some(code) = code(parse.view()) {
            collect(code, text, &mut Position { offset: 0, line: 1 }, &mut tokens);
        }
        for (number, token) in tokens.iter().enumerate() {
            if token.kind != IDENT || !lines.contains(&token.line) {
                continue;
            }
            let before = |distance: usize| number.checked_sub(distance).and_then(|number| tokens.get(number));
            match (before(1).map(|token| token.kind), before(2)) {
                (Some(DOT), _) => drop(self.fields.insert(token.text.to_owned())),
                (Some(COLON), Some(library)) => {
                    self.add(db, project, &format!("{}:{}", library.text, token.text));
                }
                _ => drop(self.add(db, project, token.text)),
            }
        }
    }

    /// Adds the variable to which a name in a project resolves: `nCount`, `lib:nCount`. Returns the variable if it is
    /// new.
    fn add(&mut self, db: &Database, project: Project, name: &str) -> Option<UsedVariable> {
        let path = DataPath::new(name);
        let owner = match path.library() {
            None => project,
            Some(library) => items(db, project).libraries.get(library)?.interface?,
        };
        let is_known = items(db, owner).data.contains_key(path.root());
        let variable = (project_file(db, owner), path.root().to_owned());
        (is_known && self.variables.insert(variable.clone())).then_some(variable)
    }

    /// Adds all ancestors of used variables through their fathers.
    fn add_fathers(&mut self, db: &Database) {
        let fathers = fathers(db);
        let mut next: Vec<UsedVariable> = self.variables.iter().cloned().collect();
        while let Some(variable) = next.pop() {
            let Some((project, fathers)) = fathers.get(&variable) else { continue };
            next.extend(fathers.iter().filter_map(|father| self.add(db, *project, father)));
        }
    }
}

/// Fathers of all variables, with the projects in which the fathers' names are resolved.
fn fathers(db: &Database) -> BTreeMap<UsedVariable, (Project, Vec<String>)> {
    let mut found = BTreeMap::new();
    for project in Sources::get(db).projects(db).values() {
        for file in data_files(db, *project) {
            let parse = parse(file.text(db));
            let variables = xml::root(parse.view()).map(written).unwrap_or_default();
            for variable in variables.into_iter().filter(|variable| !variable.fathers.is_empty()) {
                found.insert((project_file(db, *project), variable.name), (*project, variable.fathers));
            }
        }
    }
    found
}

/// Path of a project file.
pub(super) fn project_file(db: &Database, project: Project) -> String {
    project.manifest(db).path(db).to_string()
}

/// Text of a program or data file; `None` if the file cannot be read.
pub(super) fn text(file: &str) -> Option<String> {
    let bytes = val3_files::read(file.into(), FileClass::Program).ok()?;
    Some(encoding::decode(bytes).text)
}

/// An offset in bytes with its line, from 1 on.
struct Position {
    offset: usize,
    line: u32,
}

/// Collects code tokens. `at` is the end of the text whose lines are counted.
fn collect<'t>(node: View<'t>, text: &str, at: &mut Position, tokens: &mut Vec<CodeToken<'t>>) {
    for child in node.children_with_tokens() {
        if let Some(node) = child.as_node() {
            collect(*node, text, at, tokens);
        }
        let Some(token) = child.as_token().filter(|token| !token.kind().is_trivia()) else { continue };
        let start = usize::from(token.range().start());
        let passed = text.get(at.offset..start).unwrap_or_default();
        at.line += u32::try_from(passed.matches('\n').count()).unwrap_or_default();
        at.offset = start;
        tokens.push(CodeToken { kind: token.kind(), text: token.text(), line: at.line });
    }
}
