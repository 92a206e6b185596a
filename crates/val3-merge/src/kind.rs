//! Kinds of files, and the attributes that identify elements in them.

use std::borrow::Cow;

use val3_syntax::xml::XmlElement;

/// Kind of a merged file, determined by its extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MergedKind {
    /// Global data (`.dtx`).
    Data,
    /// Lists of programs, data files, libraries and types (`.pjx`).
    Project,
    /// A program (`.pgx`).
    Program,
    /// Controller configuration (`.cfx` and other XML).
    Settings,
}

/// Attributes that identify an entry of a list in a project file.
const ENTRIES: [&str; 3] = ["file", "alias", "name"];

/// Attributes that identify an element of the configuration among its siblings, in this order.
const SETTINGS: [&str; 4] = ["index", "key", "id", "name"];

/// Defaults of attributes in declarations, which some tools omit and other tools write.
const DEFAULTS: [(&str, &str); 5] =
    [("access", "private"), ("use", "value"), ("dimensions", "1"), ("autoload", "true"), ("password", "")];

impl MergedKind {
    /// Returns the kind of a file with this name; `None` for a file that is not merged.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        match extension.to_ascii_lowercase().as_str() {
            "dtx" => Some(Self::Data),
            "pjx" => Some(Self::Project),
            "pgx" => Some(Self::Program),
            "cfx" | "cf" | "xml" => Some(Self::Settings),
            _ => None,
        }
    }

    /// Returns the attribute that identifies an element among its siblings, with its value. The root has depth 0.
    pub(crate) fn key<'g>(self, element: XmlElement<'g>, depth: usize) -> Option<(&'static str, Cow<'g, str>)> {
        let first = |names: &[&'static str]| names.iter().find_map(|name| Some((*name, element.value(name)?)));
        match self {
            Self::Data => match element.name() {
                "Data" | "Field" => first(&["name"]),
                name if name.to_ascii_lowercase().starts_with("value") => first(&["key", "index"]),
                _ if depth == DECLARATION && element.attribute("alias").is_none() => first(&["name"]),
                _ => None,
            },
            Self::Project if depth == DECLARATION => first(&ENTRIES),
            Self::Program => match element.name() {
                "Parameter" | "Local" | "param" | "local" => first(&["name"]),
                _ => None,
            },
            Self::Settings if depth > 0 => first(&SETTINGS),
            Self::Project | Self::Settings => None,
        }
    }

    /// Returns the default for an attribute in a declaration; `None` if it has no default.
    pub(crate) fn default_of(self, attribute: &str) -> Option<&'static str> {
        let is_known = self != Self::Settings;
        DEFAULTS.iter().find(|(name, _)| is_known && *name == attribute).map(|(_, default)| *default)
    }

    /// Whether the order of the element's children has a meaning.
    pub(crate) fn is_ordered(self, name: &str) -> bool {
        self == Self::Program && matches!(name, "Parameters" | "paramSection")
    }

    /// Whether the text of the element is merged by lines.
    pub(crate) fn has_lines(self, name: &str) -> bool {
        self == Self::Program && matches!(name, "Code" | "code" | "Description" | "description")
    }
}

/// Depth of declarations: `Database`, `Datas`, `Data`, or `dataList`, `numSection`, `num`.
pub(crate) const DECLARATION: usize = 2;
