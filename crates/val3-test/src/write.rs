//! Writes projects to files as the PC tools do: without default values, and with code in CDATA if possible.

use crate::declaration::{Container, FixtureBrackets, FixtureData, FixtureParameter, quoted};
use crate::listing::{ListedProgram, ListedProject, ListedReference, Numbered};

const DECLARATION: &str = r#"<?xml version="1.0" encoding="utf-8"?>"#;
const VAL3: &str = "http://www.staubli.com/robotics/VAL3";
const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// A file with the listing line number of every line.
#[derive(Debug)]
pub(crate) struct WrittenFile {
    /// Path relative to the `usr` folder.
    pub(crate) path: String,
    pub(crate) lines: Vec<Numbered<String>>,
}

impl WrittenFile {
    fn new(path: String) -> WrittenFile {
        let mut file = WrittenFile { path, lines: Vec::new() };
        file.add(0, DECLARATION);
        file
    }

    fn add(&mut self, number: usize, text: impl Into<String>) {
        self.lines.push(Numbered { number, content: text.into() });
    }

    fn list<T>(&mut self, name: &str, items: &[T], mut item: impl FnMut(&mut WrittenFile, &T)) {
        if items.is_empty() {
            self.add(0, format!("  <{name} />"));
            return;
        }
        self.add(0, format!("  <{name}>"));
        items.iter().for_each(|it| item(self, it));
        self.add(0, format!("  </{name}>"));
    }
}

/// Creates the `.pjx`; `programs` are the `.pgx` file names.
pub(crate) fn project(project: &ListedProject, mut programs: Vec<String>) -> WrittenFile {
    programs.sort_by_key(|name| name.to_lowercase());
    let name = base_name(project);
    let mut file = WrittenFile::new(path(project, &format!("{name}.pjx")));
    file.add(0, format!(r#"<Project xmlns="{VAL3}/Project/3">"#));
    let version = escape(&project.version.content);
    let parameters = format!(r#"  <Parameters version="{version}" stackSize="5000" millimeterUnit="true" />"#);
    file.add(project.version.number, parameters);
    file.list("Programs", &programs, |file, name| file.add(0, format!(r#"    <Program file="{}" />"#, escape(name))));
    file.list("Database", &[name], |file, name| file.add(0, format!(r#"    <Data file="{name}.dtx" />"#)));
    file.list("Libraries", &project.libraries, |file, it| file.add(it.number, library(&it.content)));
    file.list("Types", &project.types, |file, it| file.add(it.number, user_type(&it.content)));
    file.add(0, "</Project>");
    file
}

fn library(library: &ListedReference) -> String {
    let autoload = if library.autoload { "" } else { r#" autoload="false""# };
    format!(r#"    <Library alias="{}" path="{}"{autoload} />"#, escape(&library.name), escape(&library.path))
}

fn user_type(ty: &ListedReference) -> String {
    format!(r#"    <Type name="{}" path="{}" />"#, escape(&ty.name), escape(&ty.path))
}

/// Creates the `.dtx`.
pub(crate) fn data_file(project: &ListedProject) -> WrittenFile {
    let mut file = WrittenFile::new(path(project, &format!("{}.dtx", base_name(project))));
    file.add(0, format!(r#"<Database xmlns:xsi="{INSTANCE}" xmlns="{VAL3}/Data/2">"#));
    file.list("Datas", &project.data, |file, it| data(file, it.number, &it.content));
    file.add(0, "</Database>");
    file
}

fn data(file: &mut WrittenFile, number: usize, data: &FixtureData) {
    let access = if data.public { "public" } else { "private" };
    let ty = stored_type(&data.ty);
    let container = match &data.shape {
        FixtureBrackets::Array(sizes) => format!(r#"xsi:type="array" type="{ty}" size="{}""#, join(sizes)),
        FixtureBrackets::Collection(_) => format!(r#"xsi:type="collection" type="{ty}""#),
    };
    let start = format!(r#"    <Data name="{}" access="{access}" {container}"#, escape(&data.name));
    let values = values(data);
    if values.is_empty() {
        return file.add(number, format!("{start} />"));
    }
    file.add(number, format!("{start}>"));
    values.into_iter().for_each(|value| file.add(0, format!("      <Value {value} />")));
    file.add(0, "    </Data>");
}

/// Attributes of values that differ from the default: links to `world` and `flange`, and the value of the first
/// element.
fn values(data: &FixtureData) -> Vec<String> {
    let father = match data.ty.as_str() {
        "frame" | "point" | "pointRx" | "pointRs" | "pointVrb" => r#" fatherId="world[0]""#,
        "tool" => r#" fatherId="flange[0]""#,
        _ => "",
    };
    let keys = match &data.shape {
        FixtureBrackets::Collection(keys) => keys.clone(),
        FixtureBrackets::Array(sizes) if !father.is_empty() => indexes(sizes),
        FixtureBrackets::Array(sizes) if data.value.is_some() => vec![first_index(sizes)],
        FixtureBrackets::Array(_) => Vec::new(),
    };
    let first = data.value.as_ref().map_or_else(String::new, |value| format!(r#" value="{}""#, escape(plain(value))));
    let value = |index: usize| if index == 0 { first.as_str() } else { "" };
    let keys = keys.iter().enumerate();
    keys.map(|(index, key)| format!(r#"key="{}"{}{father}"#, escape(key), value(index))).collect()
}

/// Creates a `.pgx`.
pub(crate) fn program(project: &ListedProject, program: &ListedProgram) -> WrittenFile {
    let head = &program.head.content;
    let mut file = WrittenFile::new(path(project, &format!("{}.pgx", head.name)));
    file.add(0, format!(r#"<Programs xmlns:xsi="{INSTANCE}" xmlns="{VAL3}/Program/2">"#));
    let access = if head.public { r#" access="public""# } else { "" };
    file.add(program.head.number, format!(r#"  <Program name="{}"{access}>"#, escape(&head.name)));
    if !head.parameters.is_empty() {
        file.add(0, format!(r#"    <Parameters xmlns="{VAL3}/Param/1">"#));
        head.parameters.iter().for_each(|it| file.add(program.head.number, parameter(it)));
        file.add(0, "    </Parameters>");
    }
    if !program.locals.is_empty() {
        file.add(0, "    <Locals>");
        program.locals.iter().for_each(|it| file.add(it.number, local(&it.content)));
        file.add(0, "    </Locals>");
    }
    code(&mut file, &program.code);
    file.add(0, "  </Program>");
    file.add(0, "</Programs>");
    file
}

fn parameter(parameter: &FixtureParameter) -> String {
    let reference = if parameter.reference { r#" use="reference""# } else { "" };
    let container = match parameter.container {
        Container::Element => format!(r#"xsi:type="element"{reference}"#),
        Container::Array { dims: 1 } => format!(r#"xsi:type="array"{reference}"#),
        Container::Array { dims } => format!(r#"xsi:type="array"{reference} dimensions="{dims}""#),
        Container::Collection => format!(r#"xsi:type="collection"{reference}"#),
    };
    format!(r#"      <Parameter name="{}" type="{}" {container} />"#, escape(&parameter.name), escape(&parameter.ty))
}

fn local(local: &FixtureData) -> String {
    let start = format!(r#"      <Local name="{}" type="{}""#, escape(&local.name), escape(&local.ty));
    match &local.shape {
        FixtureBrackets::Array(sizes) => format!(r#"{start} xsi:type="array" size="{}" />"#, join(sizes)),
        FixtureBrackets::Collection(_) => format!(r#"{start} xsi:type="collection" />"#),
    }
}

/// Writes the code: in a CDATA section, or escaped if it contains the end of a CDATA section.
fn code(file: &mut WrittenFile, lines: &[Numbered<String>]) {
    let is_escaped = lines.iter().any(|line| line.content.contains("]]>"));
    let (open, close) = if is_escaped { ("", "") } else { ("<![CDATA[", "]]>") };
    for (index, line) in lines.iter().enumerate() {
        let before = if index == 0 { format!("    <Code>{open}") } else { String::new() };
        let text = if is_escaped { escape(&line.content) } else { line.content.clone() };
        let after = if index + 1 == lines.len() { format!("{close}</Code>") } else { String::new() };
        file.add(line.number, format!("{before}{text}{after}"));
    }
}

pub(crate) fn path(project: &ListedProject, file: &str) -> String {
    format!("usrapp/{}/{file}", project.folder)
}

fn base_name(project: &ListedProject) -> &str {
    project.folder.rsplit('/').next().unwrap_or(&project.folder)
}

/// Type name in data files, in which position types have the arm's suffix.
fn stored_type(ty: &str) -> String {
    match ty {
        "point" | "joint" | "config" => format!("{ty}Rx"),
        other => escape(other),
    }
}

/// Index texts of all elements in an array.
fn indexes(sizes: &[usize]) -> Vec<String> {
    sizes.iter().fold(vec![String::new()], |keys, &size| {
        keys.iter().flat_map(|key| (0..size).map(move |index| longer(key, index))).collect()
    })
}

/// An index text with one more index.
fn longer(key: &str, index: usize) -> String {
    if key.is_empty() { index.to_string() } else { format!("{key},{index}") }
}

fn first_index(sizes: &[usize]) -> String {
    vec!["0"; sizes.len()].join(",")
}

fn join(sizes: &[usize]) -> String {
    sizes.iter().map(usize::to_string).collect::<Vec<_>>().join(" ")
}

/// Content of a string literal; other literals are unchanged.
fn plain(literal: &str) -> &str {
    quoted(literal).map_or(literal, |(text, _)| text)
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
