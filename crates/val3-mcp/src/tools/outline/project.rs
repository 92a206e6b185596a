//! Content of a project.

use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::items;
use val3_ide::{ProjectContent, TreeItem, TreeReference, project_content};

use crate::projects::folder;
use crate::roots::Roots;

/// Role of a project in a cell.
pub(super) fn role(content: &ProjectContent) -> &'static str {
    let has = |name: &str| content.programs.iter().any(|program| program.name == name);
    if has("start") {
        "application"
    } else if content.programs.is_empty() {
        "user type or data"
    } else {
        "library"
    }
}

/// Programs, data, libraries, types and tasks of a project, one per line.
pub(super) fn shown(db: &Database, roots: &Roots, project: Project) -> String {
    let content = project_content(db, project);
    let version = items(db, project).version;
    let arm = val3_analysis::arm::arm(db, project).as_ref().map_or("no arm", |arm| arm.model.name());
    let mut text = format!(
        "{} `{}` in {}, VAL 3 {version}, {arm}\n",
        role(&content),
        content.name,
        roots.shown(&folder(db, project))
    );
    section(
        &mut text,
        "programs",
        content.programs.iter().map(|item| {
            let (access, params) = item.detail.split_once('(').unwrap_or_default();
            format!("{access}{}({params}", item.name)
        }),
    );
    section(
        &mut text,
        "data",
        content.data.iter().map(|item| {
            let value = item.what.value.as_ref().map(|value| format!(" = {value}")).unwrap_or_default();
            format!("{} {}{value}", item.detail, item.name)
        }),
    );
    section(&mut text, "libraries", content.libraries.iter().map(reference));
    section(&mut text, "user types", content.types.iter().map(reference));
    text
}

/// Line of a library or user type: name, and path in the project file.
fn reference(item: &TreeItem<TreeReference>) -> String {
    let state = if item.what.project.is_some() { "" } else { " (not found)" };
    format!("{} \"{}\"{state}", item.name, item.detail)
}

fn section(text: &mut String, name: &str, lines: impl IntoIterator<Item = String>) {
    let mut lines = lines.into_iter().peekable();
    if lines.peek().is_some() {
        text.push_str(&format!("{name}:\n"));
        lines.for_each(|line| text.push_str(&format!("  {line}\n")));
    }
}
