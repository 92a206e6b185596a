//! Writes a program from text: creates its file, or changes the declarations and the code of an existing one.

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::parse;
use val3_analysis::items::program::{Header, code_element, element, header};
use val3_analysis::items::project::items;
use val3_analysis::xml::XmlElement;
use val3_lang::types::{Arm, BaseType};
use val3_syntax::xml::{indentation, line_end};
use val3_syntax::{SyntaxKind, TextRange};

use super::read;
use crate::declare::{
    NewProgram, NewVariable, into_locals, into_parameters, is_old_program, local_entry, parameter_entry, programs,
    without,
};
use crate::edit::{FileEdit, SourceChange};
use crate::rename::name_fault;
use crate::xml_list::escaped;

/// Writes a program of a project from text such as [`program_text`](super::program_text) returns. An existing program
/// keeps the parts of its file that the text does not contain, such as its description. Returns the change, and the
/// name of the program.
///
/// # Errors
/// The text cannot be read, a name or type does not exist, or the project cannot contain the program.
pub fn write_program(db: &dyn Db, project: Project, text: &str) -> Result<(SourceChange, String), String> {
    let mut new = read::program(text)?;
    complete(db, project, &mut new)?;
    let name = new.name.clone();
    let change = match items(db, project).programs.get(name.as_str()) {
        Some(file) => replace(db, *file, &new)?,
        None => create(db, project, new)?,
    };
    Ok((change, name))
}

/// Checks the names, and converts types to their spelling in files.
fn complete(db: &dyn Db, project: Project, new: &mut NewProgram) -> Result<(), String> {
    let items = items(db, project);
    name_fault(&new.name, Some(items.version)).map_or(Ok(()), Err)?;
    let arm = items.arm.unwrap_or(Arm::SixAxis);
    let variables = new.params.iter_mut().map(|(variable, _)| variable).chain(&mut new.locals);
    for NewVariable { name, type_name, .. } in variables {
        name_fault(name, Some(items.version)).map_or(Ok(()), Err)?;
        if items.types.contains_key(type_name.as_str()) || BaseType::from_file_name(type_name).is_some() {
            // Joints have no type that suits all arms.
            let base = BaseType::from_name(type_name).filter(|base| *base == BaseType::Joint);
            if let Some(joint) = base {
                *type_name = joint.file_name(arm);
            }
            continue;
        }
        let types = BaseType::DECLARABLE.map(BaseType::name).join(", ");
        return Err(format!(
            "there is no type `{type_name}` in this project: use {types}, or a type of the project file"
        ));
    }
    Ok(())
}

fn create(db: &dyn Db, project: Project, mut new: NewProgram) -> Result<SourceChange, String> {
    let same = |name: &str| name.eq_ignore_ascii_case(&new.name);
    if let Some(other) = items(db, project).programs.keys().find(|other| same(other)) {
        return Err(format!("there is already a program `{other}`: names of files do not differ in letter case alone"));
    }
    new.line_end = line_end(project.manifest(db).text(db));
    programs(db, project, &[new]).ok_or_else(|| "the project file has no place for a program".to_owned())
}

/// Edits of an existing program. Each part is only changed if it differs.
fn replace(db: &dyn Db, file: File, new: &NewProgram) -> Result<SourceChange, String> {
    let unreadable = || format!("`{}` is damaged: correct its findings first", file.path(db));
    let old = header(db, file);
    let parse = parse(db, file);
    let program = element(parse.view()).filter(|_| old.complete).ok_or_else(unreadable)?;
    let is_old = is_old_program(db, file);
    let (parameters, locals) = if is_old { ("paramSection", "localSection") } else { ("Parameters", "Locals") };
    let param_entries: Vec<String> =
        new.params.iter().map(|(variable, by_reference)| parameter_entry(is_old, variable, *by_reference)).collect();
    let local_entries: Vec<String> = new.locals.iter().map(|local| local_entry(is_old, local)).collect();
    let mut edits = Vec::new();
    if !keeps_parameters(old, new) {
        edits.extend(list(db, file, program.child(&[parameters]), is_old, &param_entries, into_parameters));
    }
    if !keeps_locals(old, new) {
        edits.extend(list(db, file, program.child(&[locals]), is_old, &local_entries, into_locals));
    }
    if old.public != new.public {
        let (range, text) = crate::access::set(file.text(db), program, new.public).ok_or_else(unreadable)?;
        edits.push(FileEdit { file, range, text });
    }
    edits.extend(code(db, file, new).ok_or_else(unreadable)?);
    edits.sort_by_key(|edit| edit.range.start());
    Ok(SourceChange::of(edits))
}

fn keeps_parameters(old: &Header, new: &NewProgram) -> bool {
    old.params.len() == new.params.len()
        && old.params.iter().zip(&new.params).all(|(old, (new, by_reference))| {
            old.name == new.name
                && old.type_name == new.type_name
                && old.by_reference == *by_reference
                && old.container == new.container
        })
}

fn keeps_locals(old: &Header, new: &NewProgram) -> bool {
    old.locals.len() == new.locals.len()
        && old
            .locals
            .iter()
            .zip(&new.locals)
            .all(|(old, new)| old.name == new.name && old.type_name == new.type_name && old.sizes == new.sizes)
}

/// Edits that replace the elements of a list.
fn list(
    db: &dyn Db,
    file: File,
    list: Option<XmlElement<'_>>,
    is_old: bool,
    entries: &[String],
    append: impl Fn(&dyn Db, File, &[String]) -> Option<FileEdit>,
) -> Vec<FileEdit> {
    let Some(list) = list else {
        return if entries.is_empty() { Vec::new() } else { append(db, file, entries).into_iter().collect() };
    };
    let elements = || list.elements().map(|element| element.view().range());
    // The old dialect always has the list.
    if entries.is_empty() && !is_old {
        return vec![without(db, file, list.view().range())];
    }
    match elements().reduce(|all, next| all.cover(next)) {
        None => append(db, file, entries).into_iter().collect(),
        Some(range) if entries.is_empty() => vec![without(db, file, range)],
        Some(range) => {
            let text = file.text(db);
            let blanks = indentation(text, range.start()).unwrap_or_default();
            let between = format!("{}{blanks}", line_end(text));
            vec![FileEdit { file, range, text: entries.join(&between) }]
        }
    }
}

/// Edit that replaces the code, in the form of the file: in a section, or escaped. `None` if the file has no code.
fn code(db: &dyn Db, file: File, new: &NewProgram) -> Option<Option<FileEdit>> {
    let lines: Vec<&str> = std::iter::once("begin").chain(new.code.iter().map(String::as_str)).chain(["end"]).collect();
    let before = crate::code_text(db, file)?;
    if before.trim().lines().map(str::trim_end).eq(lines.iter().map(|line| line.trim_end())) {
        return Some(None);
    }
    let parse = parse(db, file);
    let element = code_element(parse.view())?;
    let view = element.view();
    let tags: Vec<TextRange> = [SyntaxKind::START_TAG, SyntaxKind::END_TAG]
        .into_iter()
        .filter_map(|kind| view.child(kind).map(|tag| tag.range()))
        .collect();
    let [start, end] = tags.as_slice() else { return None };
    let text = lines.join(line_end(file.text(db)));
    let is_section = is_section(file.text(db), TextRange::new(start.end(), end.start())) && !text.contains("]]>");
    let text = if is_section { format!("<![CDATA[{text}]]>") } else { escaped(&text) };
    Some(Some(FileEdit { file, range: TextRange::new(start.end(), end.start()), text }))
}

/// Whether the text of the code is a section.
fn is_section(text: &str, range: TextRange) -> bool {
    text.get(std::ops::Range::<usize>::from(range)).is_some_and(|code| code.trim_start().starts_with("<![CDATA["))
}
