//! XML of project, data and program files: elements, attributes and namespaces, in both dialects.

use crate::types::BaseType;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A project file (`.pjx`).
    Project,
    /// A data file (`.dtx`).
    Data,
    /// A program file (`.pgx`).
    Program,
}

/// An element.
#[derive(Debug, PartialEq, Eq)]
pub struct ElementPage {
    /// Name. It is case-sensitive: the old dialect (s5, s6) uses lower case.
    pub name: &'static str,
    /// Attributes, in the order of the controller's files. The attributes of a `Value` also depend on its type
    /// ([`crate::types::attributes`]).
    pub attributes: &'static [AttributePage],
    /// Child elements, in the order of the controller's files.
    pub children: &'static [&'static str],
    /// Declared namespace, at the root of a file or file part.
    pub namespace: Option<&'static str>,
}

/// An attribute.
#[derive(Debug, PartialEq, Eq)]
pub struct AttributePage {
    /// Name with prefix.
    pub name: &'static str,
    /// Whether the attribute is optional.
    pub presence: Presence,
    /// Valid words; empty if any text is valid.
    pub values: &'static [&'static str],
}

/// Whether an attribute is optional.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Presence {
    /// Required, because it identifies the declared item.
    Required,
    /// Written by every known tool. A missing attribute is reported, and has this value.
    Expected(&'static str),
    /// May be missing, and then has this value.
    Optional(&'static str),
}

impl ElementPage {
    /// Finds an attribute by name.
    #[must_use]
    pub fn attribute(&self, name: &str) -> Option<&'static AttributePage> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }
}

impl AttributePage {
    const fn of(mut self, values: &'static [&'static str]) -> Self {
        self.values = values;
        self
    }
}

/// Finds an element by name in a file of this kind.
#[must_use]
pub fn find(file: FileKind, name: &str) -> Option<&'static ElementPage> {
    let elements = match file {
        FileKind::Project => PROJECT,
        FileKind::Data => DATA,
        FileKind::Program => PROGRAM,
    };
    let old_data = || (file == FileKind::Data && BaseType::from_file_name(name).is_some()).then_some(&OLD_DATA);
    elements.iter().find(|element| element.name == name).or_else(old_data)
}

/// Finds an element by name that declares a variable: data, a field, a parameter or a local.
#[must_use]
pub fn variable(name: &str) -> Option<(FileKind, &'static ElementPage)> {
    let file = match name {
        "Data" | "Field" => FileKind::Data,
        "Parameter" | "Local" | "param" | "local" => FileKind::Program,
        _ => return None,
    };
    Some((file, find(file, name)?))
}

const fn required(name: &'static str) -> AttributePage {
    AttributePage { name, presence: Presence::Required, values: &[] }
}

const fn expected(name: &'static str, default: &'static str) -> AttributePage {
    AttributePage { name, presence: Presence::Expected(default), values: &[] }
}

const fn optional(name: &'static str, default: &'static str) -> AttributePage {
    AttributePage { name, presence: Presence::Optional(default), values: &[] }
}

const fn root(name: &'static str, namespace: &'static str, children: &'static [&'static str]) -> ElementPage {
    ElementPage { name, attributes: &[], children, namespace: Some(namespace) }
}

const fn list(name: &'static str, children: &'static [&'static str]) -> ElementPage {
    ElementPage { name, attributes: &[], children, namespace: None }
}

const fn item(name: &'static str, attributes: &'static [AttributePage]) -> ElementPage {
    ElementPage { name, attributes, children: &[], namespace: None }
}

const TRUTH: &[&str] = &["true", "false"];
const ACCESS: &[&str] = &["public", "private"];
const STORED: &[&str] = &["array", "collection"];
const PASSED: &[&str] = &["element", "array", "collection"];

const PROJECT: &[ElementPage] = &[
    root(
        "Project",
        "http://www.staubli.com/robotics/VAL3/Project/3",
        &["Parameters", "Programs", "Database", "Libraries", "Types"],
    ),
    item("Parameters", PARAMETERS),
    list("Programs", &["Program"]),
    item("Program", &[required("file")]),
    list("Database", &["Data"]),
    item("Data", &[required("file")]),
    list("Libraries", &["Library"]),
    item(
        "Library",
        &[required("alias"), required("path"), optional("autoload", "true").of(TRUTH), optional("password", "")],
    ),
    list("Types", &["Type"]),
    item("Type", &[required("name"), required("path")]),
    root("project", "ProjectNameSpace", &["parameters", "programSection", "dataSection", "aliasSection"]),
    item("parameters", PARAMETERS),
    list("programSection", &["program"]),
    item("program", &[required("file")]),
    list("dataSection", &["data"]),
    item("data", &[required("file")]),
    list("aliasSection", &["alias"]),
    item(
        "alias",
        &[required("name"), required("interface"), optional("autoload", "true").of(TRUTH), optional("password", "")],
    ),
];

const PARAMETERS: &[AttributePage] =
    &[expected("version", "s7.11"), optional("stackSize", "5000"), optional("millimeterUnit", "true").of(TRUTH)];

const DATA: &[ElementPage] = &[
    root("Database", "http://www.staubli.com/robotics/VAL3/Data/2", &["Datas"]),
    list("Datas", &["Data"]),
    ElementPage {
        name: "Data",
        attributes: &[
            required("name"),
            expected("access", "private").of(ACCESS),
            expected("xsi:type", "array").of(STORED),
            required("type"),
            expected("size", "1"),
        ],
        children: &["Value"],
        namespace: None,
    },
    ElementPage { name: "Value", attributes: &[required("key")], children: &["Field"], namespace: None },
    ElementPage {
        name: "Field",
        attributes: &[
            required("name"),
            expected("xsi:type", "array").of(STORED),
            required("type"),
            expected("size", "1"),
        ],
        children: &["Value"],
        namespace: None,
    },
    root("dataList", "DataNameSpace", &[]),
];

/// A data element in the old dialect has its type as name, and its size is the number of values.
const OLD_DATA: ElementPage = item(
    "",
    &[required("name"), optional("public", "false").of(TRUTH), optional("privilege", "0"), optional("size", "1")],
);

const PROGRAM: &[ElementPage] = &[
    root("Programs", "http://www.staubli.com/robotics/VAL3/Program/2", &["Program"]),
    ElementPage {
        name: "Program",
        attributes: &[required("name"), optional("access", "private").of(ACCESS)],
        children: &["Description", "Parameters", "Locals", "Code"],
        namespace: None,
    },
    list("Description", &[]),
    root("Parameters", "http://www.staubli.com/robotics/VAL3/Param/1", &["Parameter"]),
    item(
        "Parameter",
        &[
            required("name"),
            required("type"),
            optional("xsi:type", "element").of(PASSED),
            optional("use", "value").of(&["value", "reference"]),
            optional("dimensions", "1").of(&["1", "2", "3"]),
        ],
    ),
    list("Locals", &["Local"]),
    item(
        "Local",
        &[required("name"), required("type"), optional("xsi:type", "array").of(PASSED), optional("size", "1")],
    ),
    list("Code", &[]),
    root("programList", "ProgramNameSpace", &["program"]),
    ElementPage {
        name: "program",
        attributes: &[required("name"), optional("public", "false").of(TRUTH)],
        children: &["description", "paramSection", "localSection", "source"],
        namespace: None,
    },
    list("description", &[]),
    list("paramSection", &["param"]),
    item("param", &[required("name"), required("type"), optional("byVal", "true").of(TRUTH)]),
    list("localSection", &["local"]),
    item("local", &[required("name"), required("type"), optional("size", "1")]),
    list("source", &["code"]),
    list("code", &[]),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_child_is_an_element_of_the_same_file() {
        for (file, elements) in [(FileKind::Project, PROJECT), (FileKind::Data, DATA), (FileKind::Program, PROGRAM)] {
            for element in elements {
                assert!(element.children.iter().all(|child| find(file, child).is_some()), "{}", element.name);
                assert_eq!(find(file, element.name), Some(element));
            }
        }
    }

    #[test]
    fn elements_of_the_same_name_differ_by_file() {
        assert!(find(FileKind::Project, "Program").is_some_and(|program| program.attribute("file").is_some()));
        assert!(find(FileKind::Program, "Program").is_some_and(|program| program.attribute("access").is_some()));
        assert!(find(FileKind::Data, "Program").is_none());
    }

    #[test]
    fn data_of_the_old_dialect_are_named_after_their_type() {
        assert!(find(FileKind::Data, "jointRs").is_some_and(|data| data.attribute("privilege").is_some()));
        assert!(find(FileKind::Project, "num").is_none());
    }

    #[test]
    fn words_contain_the_default() {
        let attributes = [PROJECT, DATA, PROGRAM].into_iter().flatten().flat_map(|element| element.attributes);
        for attribute in attributes.filter(|attribute| !attribute.values.is_empty()) {
            if let Presence::Expected(default) | Presence::Optional(default) = attribute.presence {
                assert!(attribute.values.contains(&default), "{}", attribute.name);
            }
        }
    }
}
