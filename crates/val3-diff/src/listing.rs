//! A file as readable text with stable lines, for tools that compare text.

use std::fmt::Write as _;

use camino::Utf8Path;
use val3_analysis::placement::shown;

use crate::read::data::{self, DataVersion};
use crate::read::entries::XmlEntry;
use crate::read::program::ProgramVersion;
use crate::read::project::ProjectVersion;
use crate::read::settings;
use crate::tree::{has_extension, text_of};

/// Formats a file as text: the code of a program with its header, data with one line for each element, or the entries
/// of a project file. Broken and other files are returned unchanged.
///
/// # Errors
/// If the bytes cannot be decoded, with the reason.
pub fn listing(path: &Utf8Path, bytes: &[u8]) -> Result<String, String> {
    let text = text_of(bytes)?;
    let read = if has_extension(path, &["pgx"]) {
        ProgramVersion::read(&text).map(|program| of_program(&program))
    } else if has_extension(path, &["dtx"]) {
        of_data(&text)
    } else if has_extension(path, &["pjx"]) {
        ProjectVersion::read(&text).map(|project| of_project(&project))
    } else if has_extension(path, &["cfx", "cf"]) {
        settings::read(&text).map(|entries| entries.iter().map(entry_line).collect())
    } else {
        None
    };
    Ok(read.unwrap_or_else(|| text.to_string()))
}

fn entry_line(entry: &XmlEntry) -> String {
    format!("{} = {}\n", entry.path, entry.value)
}

fn of_program(program: &ProgramVersion) -> String {
    let mut out = String::new();
    for line in program.description.lines() {
        let _ = writeln!(out, "{line}");
    }
    let _ = writeln!(out, "{} program {}", program.access(), program.signature());
    for (_, local) in program.locals() {
        let _ = writeln!(out, "  {local}");
    }
    let _ = writeln!(out, "{}", program.code.text());
    out
}

fn of_data(text: &str) -> Option<String> {
    let parse = val3_syntax::parse(text);
    val3_analysis::xml::root(parse.view()).filter(|_| parse.errors().is_empty())?;
    let data = data::read(parse.view());
    Some(data.iter().map(one).collect())
}

fn one(data: &DataVersion) -> String {
    let access = if data.decl.public { "public " } else { "" };
    let mut out = format!("{access}{}\n", data.declaration());
    for (path, value) in &data.values {
        if let Some(value) = value.shown() {
            let _ = writeln!(out, "  {} = {value}", shown(path));
        }
    }
    out
}

fn of_project(project: &ProjectVersion) -> String {
    let mut out = String::new();
    for (name, value) in &project.parameters {
        let _ = writeln!(out, "{name} {value}");
    }
    for (word, files) in [("program", &project.manifest.programs), ("data", &project.manifest.data)] {
        for file in files {
            let _ = writeln!(out, "{word} {file}");
        }
    }
    for (word, references) in [("library", project.libraries()), ("type", project.types())] {
        for (name, path) in references {
            let _ = writeln!(out, "{word} {name} {path}");
        }
    }
    out
}
