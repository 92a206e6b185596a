//! Files of a project in the format of the Robotics Suite.

use super::GeneratedFile;
use super::model::{Container, Data, Parameter, Program, Project, ReferencedProject, Type, Variable};

const NAMESPACE: &str = "http://www.staubli.com/robotics/VAL3";
const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// Returns all files of a project.
pub(super) fn files(project: &Project) -> Vec<GeneratedFile> {
    let mut contents = vec![
        (format!("{}.pjx", project.name), project_file(project)),
        (format!("{}.dtx", project.name), data_file(&project.data)),
    ];
    let programs = project.programs.iter();
    contents.extend(programs.map(|program| (format!("{}.pgx", program.signature.name), program_file(program))));
    contents.into_iter().map(|(name, text)| file(&project.folder, &name, &text)).collect()
}

/// Returns a file of the application in the folder `folder`.
fn file(folder: &str, name: &str, text: &str) -> GeneratedFile {
    GeneratedFile {
        path: format!("usr/usrapp/{folder}/{name}"),
        text: format!("\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\"?>\n{text}"),
    }
}

fn project_file(project: &Project) -> String {
    let mut text = format!("<Project xmlns=\"{NAMESPACE}/Project/3\">\n");
    text += "  <Parameters version=\"s7.11.3\" stackSize=\"5000\" millimeterUnit=\"true\" />\n";
    let mut programs: Vec<_> = project.programs.iter().map(|program| &program.signature.name).collect();
    programs.sort_by_key(|name| name.to_ascii_lowercase());
    let programs = programs.iter().map(|name| format!("    <Program file=\"{name}.pgx\" />\n"));
    text += &list("Programs", programs);
    text += &list("Database", std::iter::once(format!("    <Data file=\"{}.dtx\" />\n", project.name)));
    text += &list("Libraries", project.libraries.iter().map(|library| reference("Library alias", library)));
    text += &list("Types", project.types.iter().map(|ty| reference("Type name", ty)));
    text + "</Project>"
}

fn list(element: &str, entries: impl Iterator<Item = String>) -> String {
    let entries: String = entries.collect();
    if entries.is_empty() {
        return format!("  <{element} />\n");
    }
    format!("  <{element}>\n{entries}  </{element}>\n")
}

fn reference(head: &str, project: &ReferencedProject) -> String {
    let ReferencedProject { name, folder } = project;
    let file = folder.rsplit('/').next().unwrap_or(folder);
    format!("    <{head}=\"{name}\" path=\"Disk://{folder}/{file}.pjx\" />\n")
}

fn data_file(data: &[Data]) -> String {
    let entries: String = data.iter().map(data_entry).collect();
    let entries =
        if entries.is_empty() { "  <Datas />\n".to_owned() } else { format!("  <Datas>\n{entries}  </Datas>\n") };
    format!("<Database xmlns:xsi=\"{INSTANCE}\" xmlns=\"{NAMESPACE}/Data/2\">\n{entries}</Database>")
}

fn data_entry(data: &Data) -> String {
    let Variable { name, ty, container } = &data.variable;
    let access = if data.public { "public" } else { "private" };
    let shape = match container {
        Container::Collection(_) => format!("xsi:type=\"collection\" type=\"{}\"", ty.file_name()),
        other => format!("xsi:type=\"array\" type=\"{}\" size=\"{}\"", ty.file_name(), size(*other)),
    };
    let head = format!("    <Data name=\"{name}\" access=\"{access}\" {shape}");
    match values(*ty, *container) {
        values if values.is_empty() => format!("{head} />\n"),
        values => format!("{head}>\n{values}    </Data>\n"),
    }
}

/// Formats the size as in data files: `3 4`.
fn size(container: Container) -> String {
    match container {
        Container::One | Container::Collection(_) => "1".to_owned(),
        Container::Array(size) => size.to_string(),
        Container::Grid(rows, columns) => format!("{rows} {columns}"),
    }
}

/// Formats values that differ from the default. Links to a father are always written.
fn values(ty: Type, container: Container) -> String {
    let keys: Vec<String> = match container {
        Container::One => vec!["0".to_owned()],
        Container::Array(size) => (0..size).map(|index| index.to_string()).collect(),
        Container::Grid(..) => Vec::new(),
        Container::Collection(keys) => keys.iter().map(|key| (*key).to_owned()).collect(),
    };
    let attributes = match ty {
        Type::Num => "value=\"25\"",
        Type::Text => "value=\"a &lt; b\"",
        Type::Point => "x=\"312.5\" z=\"-40\" rz=\"90\" fatherId=\"world[0]\"",
        Type::Joint => "j2=\"-30\" j3=\"120\" j5=\"90\"",
        Type::Frame => "x=\"500\" y=\"-120\" fatherId=\"world[0]\"",
        Type::Tool => "z=\"180\" fatherId=\"flange[0]\"",
        Type::Mdesc => "accel=\"50\" vel=\"50\" decel=\"50\" leave=\"20\" reach=\"20\"",
        Type::Bool | Type::Trsf | Type::Dio | Type::Slot => return String::new(),
    };
    keys.iter().map(|key| format!("      <Value key=\"{key}\" {attributes} />\n")).collect()
}

fn program_file(program: &Program) -> String {
    let name = &program.signature.name;
    let access = if program.public { " access=\"public\"" } else { "" };
    let mut text = format!("<Programs xmlns:xsi=\"{INSTANCE}\" xmlns=\"{NAMESPACE}/Program/2\">\n");
    text += &format!("  <Program name=\"{name}\"{access}>\n");
    text += &parameter_list(&program.signature.parameters);
    text += &local_list(&program.locals);
    text += &format!("    <Code><![CDATA[{}]]></Code>\n", program.lines.join("\n"));
    text + "  </Program>\n</Programs>"
}

fn parameter_list(parameters: &[Parameter]) -> String {
    if parameters.is_empty() {
        return String::new();
    }
    let entries: String = parameters.iter().map(parameter_entry).collect();
    format!("    <Parameters xmlns=\"{NAMESPACE}/Param/1\">\n{entries}    </Parameters>\n")
}

fn parameter_entry(parameter: &Parameter) -> String {
    let Variable { name, ty, container } = &parameter.variable;
    let shape = if *container == Container::One { "element" } else { "array" };
    let passing = if parameter.by_reference { " use=\"reference\"" } else { "" };
    format!("      <Parameter name=\"{name}\" type=\"{}\" xsi:type=\"{shape}\"{passing} />\n", ty.name())
}

fn local_list(locals: &[Variable]) -> String {
    if locals.is_empty() {
        return String::new();
    }
    let entries = locals.iter().map(|Variable { name, ty, container }| {
        let size = size(*container);
        format!("      <Local name=\"{name}\" type=\"{}\" xsi:type=\"array\" size=\"{size}\" />\n", ty.name())
    });
    format!("    <Locals>\n{}    </Locals>\n", entries.collect::<String>())
}
