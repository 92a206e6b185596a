//! Insertion of declarations into files: locals, parameters, global data, programs.

mod manifest_entries;
mod new_program;
pub(crate) mod old_data;

pub(crate) use manifest_entries::{data_entries, library, program_entries, user_type, user_types};
pub(crate) use new_program::{NewProgram, free_program_name, programs};

use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::data_files;
use val3_analysis::items::{parse, program};
use val3_analysis::xml;
use val3_lang::builtins;
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use crate::edit::FileEdit;
use crate::xml_list::{XmlList, escaped};

/// Declaration of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct NewVariable {
    pub(crate) name: String,
    /// Type name as spelled in files.
    pub(crate) type_name: String,
    pub(crate) container: Container,
    /// Sizes of the dimensions; empty for one value.
    pub(crate) sizes: Vec<u32>,
}

impl NewVariable {
    /// A variable with a single value.
    pub(crate) fn single(name: &str, type_name: &str) -> Self {
        let container = Container::Array { dims: 1 };
        Self { name: name.to_owned(), type_name: type_name.to_owned(), container, sizes: vec![1] }
    }

    fn is_single(&self) -> bool {
        self.container != Container::Collection && matches!(self.sizes.as_slice(), [] | [1])
    }

    fn size(&self) -> String {
        let sizes: Vec<String> = self.sizes.iter().map(u32::to_string).collect();
        if sizes.is_empty() { "1".to_owned() } else { sizes.join(" ") }
    }
}

/// Whether the program file has the dialect of s5 and s6.
pub(crate) fn is_old_program(db: &dyn Db, file: File) -> bool {
    program::element(parse(db, file).view()).is_some_and(|program| program.name() == "program")
}

/// Declares local variables in the program in `file`; `None` if one of them is a collection.
pub(crate) fn locals(db: &dyn Db, file: File, variables: &[&NewVariable]) -> Option<FileEdit> {
    if variables.iter().any(|variable| variable.container == Container::Collection) {
        return None;
    }
    let old = is_old_program(db, file);
    let entries: Vec<String> = variables.iter().map(|variable| local_entry(old, variable)).collect();
    into_locals(db, file, &entries)
}

/// Appends elements to the locals of the program in `file`.
pub(crate) fn into_locals(db: &dyn Db, file: File, entries: &[String]) -> Option<FileEdit> {
    match is_old_program(db, file) {
        true => into_program(db, file, "localSection", "", &["source"], entries),
        false => into_program(db, file, "Locals", "", &["Code"], entries),
    }
}

/// Element of a local.
pub(crate) fn local_entry(old: bool, variable: &NewVariable) -> String {
    let (name, ty, size) = (&variable.name, &variable.type_name, variable.size());
    if old {
        return format!("<local name=\"{name}\" type=\"{ty}\" size=\"{size}\" />");
    }
    format!("<Local name=\"{name}\" type=\"{ty}\" xsi:type=\"array\" size=\"{size}\" />")
}

/// Appends a parameter to the program in `file`.
pub(crate) fn parameter(db: &dyn Db, file: File, variable: &NewVariable, by_reference: bool) -> Option<FileEdit> {
    let old = is_old_program(db, file);
    // The old dialect has no collections, and only one-dimensional arrays.
    if old && (variable.container == Container::Collection || variable.sizes.len() > 1) {
        return None;
    }
    into_parameters(db, file, &[parameter_entry(old, variable, by_reference)])
}

/// Appends elements to the parameters of the program in `file`.
pub(crate) fn into_parameters(db: &dyn Db, file: File, entries: &[String]) -> Option<FileEdit> {
    match is_old_program(db, file) {
        true => into_program(db, file, "paramSection", "", &["localSection", "source"], entries),
        false => into_program(db, file, "Parameters", PARAMETERS, &["Locals", "Code"], entries),
    }
}

const PARAMETERS: &str = " xmlns=\"http://www.staubli.com/robotics/VAL3/Param/1\"";

/// Element of a parameter.
pub(crate) fn parameter_entry(old: bool, variable: &NewVariable, by_reference: bool) -> String {
    let (name, ty) = (&variable.name, &variable.type_name);
    if old {
        let by_value = !by_reference && variable.is_single();
        return format!("<param name=\"{name}\" type=\"{ty}\" byVal=\"{by_value}\" />");
    }
    let (kind, dims) = match variable.container {
        Container::Collection => ("collection", String::new()),
        _ if variable.is_single() => ("element", String::new()),
        _ if variable.sizes.len() > 1 => ("array", format!(" dimensions=\"{}\"", variable.sizes.len())),
        _ => ("array", String::new()),
    };
    let passing = if by_reference || kind != "element" { " use=\"reference\"" } else { "" };
    format!("<Parameter name=\"{name}\" type=\"{ty}\" xsi:type=\"{kind}\"{passing}{dims} />")
}

fn into_program(
    db: &dyn Db,
    file: File,
    name: &str,
    attributes: &str,
    followers: &[&str],
    entries: &[String],
) -> Option<FileEdit> {
    let parse = parse(db, file);
    let parent = program::element(parse.view())?;
    let list = XmlList { text: file.text(db), parent, name, attributes, followers };
    let (range, text) = list.append(entries)?;
    Some(FileEdit { file, range, text })
}

/// Declares private global data in a project, with an initial value if its type has a value attribute. `None` if the
/// project has no data file, or one of s5 or s6 that cannot represent the data.
pub(crate) fn data(db: &dyn Db, project: Project, variable: &NewVariable, value: Option<&str>) -> Option<FileEdit> {
    let file = *data_files(db, project).first()?;
    let parse = parse(db, file);
    let root = xml::root(parse.view())?;
    let entry = data_lines(root.name(), variable, value, false)?;
    let (range, text) = data_list(file.text(db), root, &variable.type_name, &entry)?;
    Some(FileEdit { file, range, text })
}

/// Lines of a data declaration in a file with this root element; `None` if the file cannot represent the data.
pub(crate) fn data_lines(root: &str, variable: &NewVariable, value: Option<&str>, public: bool) -> Option<Vec<String>> {
    match root {
        "Database" => Some(new_data(variable, value, public)),
        "dataList" => old_data::lines(variable, value, public),
        _ => None,
    }
}

/// Edit that appends a declaration to the data list for its type.
pub(crate) fn data_list(
    text: &str,
    root: xml::XmlElement<'_>,
    type_name: &str,
    entry: &[String],
) -> Option<(TextRange, String)> {
    let section = format!("{}Section", old_data::type_name(type_name));
    let name = if root.name() == "Database" { "Datas" } else { section.as_str() };
    let mut followers = old_data::SECTIONS.iter().copied().skip_while(|other| *other != name);
    followers.next();
    let followers: Vec<&str> = followers.collect();
    XmlList { text, parent: root, name, attributes: "", followers: &followers }.append(entry)
}

/// Declares public data in a project of s7 or s8.
pub(crate) fn public_data(db: &dyn Db, project: Project, variables: &[NewVariable]) -> Option<FileEdit> {
    let file = *data_files(db, project).first()?;
    let parse = parse(db, file);
    let parent = xml::root(parse.view()).filter(|root| root.name() == "Database")?;
    let list = XmlList { text: file.text(db), parent, name: "Datas", attributes: "", followers: &[] };
    let entries: Vec<String> = variables.iter().flat_map(|variable| new_data(variable, None, true)).collect();
    let (range, text) = list.append(&entries)?;
    Some(FileEdit { file, range, text })
}

fn new_data(variable: &NewVariable, value: Option<&str>, public: bool) -> Vec<String> {
    let (name, ty) = (&variable.name, &variable.type_name);
    let access = if public { "public" } else { "private" };
    let shape = match variable.container {
        Container::Collection => format!("xsi:type=\"collection\" type=\"{ty}\""),
        _ => format!("xsi:type=\"array\" type=\"{ty}\" size=\"{}\"", variable.size()),
    };
    let start = format!("<Data name=\"{name}\" access=\"{access}\" {shape}");
    let values: Vec<String> = match (value, built_in_father(ty)) {
        (Some(value), _) => vec![format!("  <Value key=\"0\" value=\"{}\" />", escaped(value))],
        (None, Some(father)) if variable.container != Container::Collection => {
            let value = |key| format!("  <Value key=\"{key}\" fatherId=\"{father}[0]\" />");
            keys(&variable.sizes).into_iter().map(value).collect()
        }
        _ => return vec![format!("{start} />")],
    };
    [vec![format!("{start}>")], values, vec!["</Data>".to_owned()]].concat()
}

/// Array keys, for example `0`, or `0,0` with two dimensions.
pub(crate) fn keys(sizes: &[u32]) -> Vec<String> {
    let indexes = |key: &str, size: u32| -> Vec<String> { (0..size).map(|index| format!("{key},{index}")).collect() };
    match sizes.split_first() {
        None => vec!["0".to_owned()],
        Some((first, rest)) => rest.iter().fold((0..*first).map(|index| index.to_string()).collect(), |keys, size| {
            keys.iter().flat_map(|key| indexes(key, *size)).collect()
        }),
    }
}

/// Default father of a new point, frame or tool.
pub(crate) fn built_in_father(type_name: &str) -> Option<&'static str> {
    let (ty, _) = BaseType::from_file_name(type_name)?;
    let father = ty.father()?;
    builtins::BUILTINS.iter().find(|builtin| builtin.ty == father).map(|builtin| builtin.name)
}

/// `stem`, or `stem` with the smallest number that makes it unused.
pub(crate) fn free(stem: &str, taken: impl Fn(&str) -> bool) -> String {
    if !taken(stem) {
        return stem.to_owned();
    }
    (2u32..).map(|number| format!("{stem}{number}")).find(|name| !taken(name)).unwrap_or_default()
}

/// Edit that removes the element at `range`, with its line.
pub(crate) fn without(db: &dyn Db, file: File, range: TextRange) -> FileEdit {
    FileEdit { file, range: crate::xml_list::whole_line(file.text(db), range), text: String::new() }
}

/// Edit that removes the local at `range`, and the list if it becomes empty. The old dialect always has the list.
pub(crate) fn without_local(db: &dyn Db, file: File, range: TextRange) -> FileEdit {
    let parse = parse(db, file);
    let list = program::element(parse.view()).and_then(|program| program.child(&["Locals"]));
    let is_last = list.is_some_and(|list| list.elements().count() == 1);
    let range = list.filter(|_| is_last).map_or(range, |list| list.view().range());
    without(db, file, range)
}

#[cfg(test)]
mod tests;
