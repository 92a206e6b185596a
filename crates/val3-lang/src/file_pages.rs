//! Descriptions of the elements and attributes of project, data and program files, one sentence each.

use crate::files::FileKind;
use crate::types::BaseType;

/// A description: the element, the attribute (empty for the element itself), the text.
type FilePage = (&'static str, &'static str, &'static str);

/// Element description. Names are case-sensitive, as in [`crate::files::find`].
#[must_use]
pub fn element(file: FileKind, name: &str) -> Option<&'static str> {
    find(file, name, "").or_else(|| (file == FileKind::Data).then(|| old_data_element(name)).flatten())
}

/// Attribute description for an element. The fields in a `Value` have their own descriptions
/// ([`crate::types::Field::doc`]).
#[must_use]
pub fn attribute(file: FileKind, element: &str, name: &str) -> Option<&'static str> {
    if name == "xmlns" || name == "xmlns:xsi" {
        return Some("Namespace of the file format. The controller refuses a file with another one.");
    }
    find(file, element, name).or_else(|| old_data_attribute(file, name))
}

fn old_data_attribute(file: FileKind, name: &str) -> Option<&'static str> {
    let attributes: &[_] = if file == FileKind::Data { OLD_DATA_ATTRIBUTES } else { &[] };
    attributes.iter().find(|(known, _)| *known == name).map(|(_, page)| *page)
}

fn find(file: FileKind, element: &str, attribute: &str) -> Option<&'static str> {
    let pages = match file {
        FileKind::Project => PROJECT,
        FileKind::Data => DATA,
        FileKind::Program => PROGRAM,
    };
    pages.iter().find(|(of, name, _)| *of == element && *name == attribute).map(|(.., page)| *page)
}

const PROJECT: &[FilePage] = &[
    ("Project", "", "An application, a library or a user type: what it consists of (s7, s8)."),
    ("project", "", "An application or a library: what it consists of (s5, s6)."),
    ("Parameters", "", "Settings of the application."),
    ("parameters", "", "Settings of the application."),
    ("Parameters", "version", VERSION),
    ("parameters", "version", VERSION),
    ("Parameters", "stackSize", STACK_SIZE),
    ("parameters", "stackSize", STACK_SIZE),
    ("Parameters", "millimeterUnit", LENGTH_UNIT),
    ("parameters", "millimeterUnit", LENGTH_UNIT),
    ("Programs", "", PROGRAMS),
    ("programSection", "", PROGRAMS),
    ("Program", "", "A program of the application."),
    ("program", "", "A program of the application."),
    ("Program", "file", PROGRAM_FILE),
    ("program", "file", PROGRAM_FILE),
    ("Database", "", "The data file of the application."),
    ("dataSection", "", "The data file of the application."),
    ("Data", "", "A data file of the application."),
    ("data", "", "A data file of the application."),
    ("Data", "file", DATA_FILE),
    ("data", "file", DATA_FILE),
    ("Libraries", "", LIBRARIES),
    ("aliasSection", "", LIBRARIES),
    ("Library", "", LIBRARY),
    ("alias", "", LIBRARY),
    ("Library", "alias", ALIAS),
    ("alias", "name", ALIAS),
    ("Library", "path", LIBRARY_PATH),
    ("alias", "interface", LIBRARY_PATH),
    ("Library", "autoload", AUTOLOAD),
    ("alias", "autoload", AUTOLOAD),
    ("Library", "password", PASSWORD),
    ("alias", "password", PASSWORD),
    ("Types", "", "The user types of the application, by name."),
    ("Type", "", "A user type: its fields are the public data of another project."),
    ("Type", "name", "Name of the user type in this application."),
    ("Type", "path", "Path of the project whose public data are the fields."),
];

const VERSION: &str = "Version of VAL 3 that the application is written for.";
const STACK_SIZE: &str = "Memory for local variables and calls, in bytes. A task that needs more stops with error 41.";
const LENGTH_UNIT: &str = "Lengths are in millimetres (`true`) or inches (`false`).";
const PROGRAMS: &str = "The programs of the application. A program that is not listed does not exist for it.";
const PROGRAM_FILE: &str = "File of the program. It has the name of the program and lies in the folder of the \
    application; from s8.20 on it may lie in a folder below.";
const DATA_FILE: &str = "Data file in the folder of the application; it has the name of the application.";
const LIBRARIES: &str = "The libraries that the application uses, by identifier.";
const LIBRARY: &str = "A library identifier, and the project that gives its interface.";
const ALIAS: &str = "Identifier that code writes before `:` for items of the library.";
const LIBRARY_PATH: &str = "Path of the project that gives the interface of the library: its public data and programs.";
const AUTOLOAD: &str = "The library is loaded with the application (`true`), or by `libLoad` while it runs (`false`).";
const PASSWORD: &str = "Password of a library that is an encrypted archive; empty for others.";

const DATA: &[FilePage] = &[
    ("Database", "", "The global data of the application with their initial values (s7, s8)."),
    ("dataList", "", "The global data of the application with their initial values, a section for each type (s5, s6)."),
    ("Datas", "", "The global data, in any order."),
    ("Data", "", "A global variable: an array, of which a single value is the smallest one, or a collection."),
    ("Data", "name", VARIABLE_NAME),
    ("Data", "access", "Whether other projects may use the variable. The fields of a user type are its public data."),
    ("Data", "xsi:type", STORED),
    ("Data", "type", "Type of each value. Positions are bound to an arm: `Rx` for six axes, `Rs` for SCARA."),
    ("Data", "size", SIZE),
    ("Value", "", "An initial value. A value that is missing has the defaults of its type."),
    ("Value", "key", "Index in an array (`2`, or `2,1` with two dimensions), or key in a collection."),
    ("Field", "", "A field of a value of a user type."),
    ("Field", "name", "Name of the field: public data of the project of the type."),
    ("Field", "xsi:type", STORED),
    ("Field", "type", "Type of the field, as the project of the user type declares it."),
    ("Field", "size", SIZE),
];

const VARIABLE_NAME: &str = "Name of the variable. Up to s7 it has at most 15 characters.";
const STORED: &str = "How the values are stored: an `array` has indexes, a `collection` has keys.";
const SIZE: &str = "Number of values; with two or three dimensions one number for each, separated by a blank.";

const PROGRAM: &[FilePage] = &[
    ("Programs", "", "A file with one program (s7, s8)."),
    ("programList", "", "A file with one program (s5, s6)."),
    ("Program", "", PROGRAM_ELEMENT),
    ("program", "", PROGRAM_ELEMENT),
    ("Program", "name", PROGRAM_NAME),
    ("program", "name", PROGRAM_NAME),
    ("Program", "access", "Whether other projects may call the program."),
    ("program", "public", "Whether other projects may call the program."),
    ("Description", "", "Text about the program."),
    ("description", "", "Text about the program."),
    ("Parameters", "", "The parameters, in the order of the arguments."),
    ("paramSection", "", "The parameters, in the order of the arguments."),
    ("Parameter", "", "A parameter."),
    ("param", "", "A parameter."),
    ("Parameter", "name", VARIABLE_NAME),
    ("param", "name", VARIABLE_NAME),
    ("Parameter", "type", LOCAL_TYPE),
    ("param", "type", LOCAL_TYPE),
    ("Parameter", "xsi:type", "What is passed: one value (`element`), an `array` or a `collection`."),
    (
        "Parameter",
        "use",
        "Passed by `value`, so that the caller keeps its own, or by `reference`. Arrays and collections are always \
         passed by reference.",
    ),
    ("Parameter", "dimensions", "Number of dimensions of an array."),
    ("param", "byVal", "Passed by value (`true`), so that the caller keeps its own, or by reference (`false`)."),
    ("Locals", "", "The local variables. Each call of the program has its own."),
    ("localSection", "", "The local variables. Each call of the program has its own."),
    ("Local", "", "A local variable. It has the defaults of its type when the program begins."),
    ("local", "", "A local variable. It has the defaults of its type when the program begins."),
    ("Local", "name", VARIABLE_NAME),
    ("local", "name", VARIABLE_NAME),
    ("Local", "type", LOCAL_TYPE),
    ("local", "type", LOCAL_TYPE),
    ("Local", "xsi:type", "How the values are stored. Local variables are arrays; a single value has size 1."),
    ("Local", "size", SIZE),
    ("local", "size", "Number of values."),
    ("Code", "", CODE),
    ("source", "", CODE),
    ("code", "", CODE),
];

const PROGRAM_ELEMENT: &str = "A program: its parameters, local variables and code.";
const PROGRAM_NAME: &str = "Name of the program, which is that of the file.";
const LOCAL_TYPE: &str = "Type of each value: a built-in type, or a user type of the application.";
const CODE: &str = "The code, from `begin` to `end`.";

const OLD_DATA_ATTRIBUTES: &[(&str, &str)] = &[
    ("name", VARIABLE_NAME),
    ("public", "Whether other projects may use the variable."),
    ("privilege", "Access level of the variable on the pendant."),
    ("size", "Number of values."),
    ("index", "Index of the value."),
    ("value", "The initial value."),
    ("alias", "Library identifier of the project that has it; empty for the own project."),
    ("fatherIndex", "Index in the frame or tool it is relative to."),
    ("ioIndex", "Index in the output that opens and closes the tool."),
];

/// Data elements of the old dialect: sections, variables named after their type, values and their parts.
fn old_data_element(name: &str) -> Option<&'static str> {
    let is_type = |name: &str| BaseType::from_file_name(name).is_some();
    match name {
        "io" => Some("Output that opens and closes the tool."),
        _ if is_type(name) => Some("A global variable, called as its type."),
        _ if name.strip_suffix("Section").is_some_and(is_type) => Some("The global variables of one type."),
        _ if name.ends_with("Father") => Some("Frame or tool that the values are relative to."),
        _ if name.starts_with("value") => Some("An initial value, with its index."),
        _ if name.ends_with("Value") => Some("A part of the initial value."),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::{attribute, element};
    use crate::files::{self, FileKind};

    const ROOTS: [(FileKind, &str); 6] = [
        (FileKind::Project, "Project"),
        (FileKind::Project, "project"),
        (FileKind::Data, "Database"),
        (FileKind::Data, "dataList"),
        (FileKind::Program, "Programs"),
        (FileKind::Program, "programList"),
    ];

    #[test]
    fn every_element_and_attribute_has_a_page() {
        for (file, root) in ROOTS {
            let mut rest = vec![root];
            while let Some(name) = rest.pop() {
                let known = files::find(file, name).unwrap();
                assert!(element(file, name).is_some(), "{name}");
                for found in known.attributes {
                    assert!(attribute(file, name, found.name).is_some(), "{name}@{}", found.name);
                }
                rest.extend(known.children.iter().filter(|child| name != "Field" || **child != "Value"));
            }
        }
    }

    #[test]
    fn every_page_describes_an_element_or_attribute() {
        for (file, pages) in
            [(FileKind::Project, super::PROJECT), (FileKind::Data, super::DATA), (FileKind::Program, super::PROGRAM)]
        {
            for (of, name, _) in pages {
                let known = files::find(file, of).unwrap();
                assert!(name.is_empty() || known.attribute(name).is_some(), "{of}@{name}");
            }
        }
    }

    #[test]
    fn data_of_the_old_dialect_have_pages() {
        for name in ["numSection", "jointRs", "valueNum", "tpValue", "pFather", "io"] {
            assert!(element(FileKind::Data, name).is_some(), "{name}");
        }
        assert_eq!(element(FileKind::Data, "thingSection"), None);
        assert!(attribute(FileKind::Data, "valueNum", "index").is_some());
        assert_eq!(attribute(FileKind::Program, "Local", "index"), None);
    }
}
