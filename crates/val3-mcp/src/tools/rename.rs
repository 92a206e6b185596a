//! `rename`: renames a symbol and all its uses.

use schemars::JsonSchema;
use serde::Deserialize;
use smol_str::SmolStr;
use val3_analysis::db::{Database, FileRange, Project};
use val3_analysis::items::declarations;
use val3_analysis::items::project::items;
use val3_analysis::system::Disk;
use val3_ide::{FilePosition, rename};

use crate::answer::Answer;
use crate::changes::Changes;
use crate::projects::{self, unknown};
use crate::refusal::Refusal;
use crate::tool::{Call, Definition, Effect};
use crate::written::changed;

/// The tool.
pub(super) struct Rename;

/// Arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Arguments {
    /// Folder of the project that declares the name; for a field, the folder of the user type
    path: String,
    /// Program, global data, field, library identifier or user type; with `program` a parameter or local
    name: String,
    /// New name
    to: String,
    /// Program that declares the parameter or local
    program: Option<String>,
    /// Only show the effect, and write nothing
    #[serde(default)]
    dry_run: bool,
}

impl Definition for Rename {
    const NAME: &'static str = "rename";
    const TITLE: &'static str = "Rename";
    const DESCRIPTION: &'static str = "Renames a declaration and all its uses in the programs, data and project files of \
        all projects of the cell, also in libraries that share an interface. Refused if the meaning of any code would \
        change.";
    const EFFECT: Effect = Effect::WritesOnce;
    type Arguments = Arguments;

    fn call(call: &Call<'_>, arguments: Arguments) -> Result<Answer, Refusal> {
        let path = call.roots.resolve(&arguments.path)?;
        // All projects of the root are read, because they may use the name.
        let root = call.roots.first();
        let workspace = projects::read(&Disk, call.roots, if path.starts_with(root) { root } else { &path })?;
        let project = projects::only(&workspace, call.roots, &path)?;
        let db = &workspace.db;
        let FileRange { file, range } = declaration(db, project, &arguments)?;
        let at = FilePosition { file, offset: range.start() };
        let change = rename(db, at, &arguments.to).map_err(|error| Refusal(error.0))?;
        let changes = Changes::of(db, call.roots, &change)?.renaming(&arguments.name, &arguments.to);
        changed(call, &changes, root, arguments.dry_run)
    }
}

/// Location of the declaration.
fn declaration(db: &Database, project: Project, arguments: &Arguments) -> Result<FileRange, Refusal> {
    let items = items(db, project);
    let name = SmolStr::new(&arguments.name);
    if let Some(program) = &arguments.program {
        let file =
            *items.programs.get(program.as_str()).ok_or_else(|| unknown("program", program, items.programs.keys()))?;
        let header = val3_analysis::items::program::header(db, file);
        let names = header.params.iter().map(|param| &param.name).chain(header.locals.iter().map(|local| &local.name));
        let found = declarations::param(db, file, name.clone()).or_else(|| declarations::local(db, file, name));
        return found.ok_or_else(|| unknown("parameter or local", &arguments.name, names));
    }
    let found = items.programs.get(&name).and_then(|file| declarations::program(db, *file));
    let found = found.or_else(|| declarations::data(db, items.data.get(&name)?.file, name.clone()));
    let found = found.or_else(|| declarations::library(db, project, name.clone()));
    let found = found.or_else(|| declarations::user_type(db, project, name));
    let names = items.programs.keys().chain(items.data.keys()).chain(items.libraries.keys()).chain(items.types.keys());
    found.ok_or_else(|| unknown("name", &arguments.name, names))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use expect_test::expect;
    use serde_json::json;

    use super::*;
    use crate::command::CommandEnd;
    use crate::testing::{Folder, call};

    const PROJECT: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
  <Programs>
    <Program file="pick.pgx" />
    <Program file="start.pgx" />
    <Program file="stop.pgx" />
  </Programs>
  <Database><Data file="cell.dtx" /></Database>
</Project>
"#;

    const DATA: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas><Data name="nUnused" access="private" xsi:type="array" type="num" size="1" /></Datas>
</Database>
"#;

    /// Program with these lines, and a line with an error.
    fn program(name: &str, code: &str) -> String {
        format!(
            r#"<?xml version="1.0" encoding="utf-8"?>
<Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="{name}"><Code><![CDATA[begin
{code}
end]]></Code></Program>
</Programs>
"#
        )
    }

    fn cell() -> Folder {
        let file = |name: &str| format!("cell/{name}");
        Folder::new(&[
            (&file("cell.pjx"), PROJECT),
            (&file("cell.dtx"), DATA),
            (&file("pick.pgx"), &program("pick", "  nMissing=1")),
            (&file("start.pgx"), &program("start", "  call pick()\n  call pick(1)")),
            (&file("stop.pgx"), &program("stop", "")),
        ])
    }

    /// Answer without the changed lines.
    fn renamed(folder: &Folder, name: &str, to: &str) -> String {
        let unexpected = Err(CommandEnd::Start("no command was expected".to_owned()));
        let arguments = json!({ "path": "cell", "name": name, "to": to });
        let answer = call(folder, &crate::tool::Tool::of::<Rename>(), arguments, unexpected).unwrap();
        let at = answer.text.find("new finding").unwrap();
        answer.text.get(at.saturating_sub(2)..).unwrap().to_owned()
    }

    #[test]
    fn a_renamed_declaration_has_the_findings_that_it_had_before() {
        for (name, to) in [("pick", "grip"), ("nUnused", "nSpare")] {
            assert_eq!(renamed(&cell(), name, to), "0 new findings, 0 solved\n", "{name}");
        }
    }

    #[test]
    fn the_file_of_a_renamed_program_is_moved() {
        let folder = cell();
        renamed(&folder, "pick", "grip");
        let names = fs::read_dir(folder.path().join("cell")).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<String> = names.map(|name| name.into_string().unwrap()).collect();
        names.sort_unstable();
        expect!["cell.dtx cell.pjx grip.pgx start.pgx stop.pgx"].assert_eq(&names.join(" "));
    }
}
