//! Elements and attributes to fill in.

use val3_lang::files::{self, Attribute, Element, FileKind, Presence};

/// Attributes that the controller's files leave out where they have their default.
const LEFT_OUT: [&str; 6] = ["autoload", "password", "access", "use", "dimensions", "privilege"];

/// Elements without which another one says nothing.
const MANDATORY: [(FileKind, &str, &[&str]); 8] = [
    (FileKind::Project, "Project", &["Parameters", "Programs", "Database"]),
    (FileKind::Project, "project", &["parameters", "programSection", "dataSection"]),
    (FileKind::Data, "Database", &["Datas"]),
    (FileKind::Program, "Programs", &["Program"]),
    (FileKind::Program, "Program", &["Code"]),
    (FileKind::Program, "programList", &["program"]),
    (FileKind::Program, "program", &["paramSection", "localSection", "source"]),
    (FileKind::Program, "source", &["code"]),
];

/// Roots whose attributes have the prefix `xsi`.
const WITH_XSI: [&str; 2] = ["Database", "Programs"];
const XSI: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// A text with places to fill in, and the same without.
#[derive(Debug, Default)]
pub(super) struct Snippet {
    pub(super) text: String,
    pub(super) plain: String,
    places: u32,
    has_last: bool,
}

impl Snippet {
    /// Plain text.
    pub(super) fn push(&mut self, text: &str) {
        self.text += &text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}");
        self.plain += text;
    }

    /// A place to fill in, with a text that is there already.
    pub(super) fn place(&mut self, text: &str) {
        self.places += 1;
        let escaped = text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}");
        self.text += &format!("${{{}:{escaped}}}", self.places);
        self.plain += text;
    }

    /// A place for one of some words, the first of which is there already.
    fn choice(&mut self, words: &[&str]) {
        self.places += 1;
        self.text += &format!("${{{}|{}|}}", self.places, words.join(","));
        self.plain += words.first().unwrap_or(&"");
    }

    /// Where the cursor stays.
    fn last(&mut self) {
        if !self.has_last {
            self.text += "$0";
            self.has_last = true;
        }
        // Without places to fill in, the line would be blank.
        if let Some(before) = self.plain.trim_end_matches(' ').strip_suffix('\n') {
            self.plain.truncate(before.len());
        }
    }

    /// ` name="value"` with a place for the value, which has this text if it is known.
    pub(super) fn attribute(&mut self, attribute: &Attribute, known: Option<&str>) {
        let default = match attribute.presence {
            Presence::Required => attribute.name,
            Presence::Expected(default) | Presence::Optional(default) => default,
        };
        self.push(&format!("{}=\"", attribute.name));
        match (known, attribute.values) {
            (None, [_, ..]) => {
                let others = attribute.values.iter().filter(|word| **word != default);
                let words: Vec<&str> = [default].into_iter().chain(others.copied()).collect();
                self.choice(&words);
            }
            _ => self.place(known.unwrap_or(default)),
        }
        self.push("\"");
    }

    /// A new element without its first `<`; `indent` is before its further lines. `known` gives values that are
    /// likelier than the defaults.
    pub(super) fn element(
        &mut self,
        file: FileKind,
        element: &Element,
        indent: &str,
        known: &dyn Fn(&str) -> Option<String>,
    ) {
        self.push(element.name);
        if WITH_XSI.contains(&element.name) && element.namespace.is_some() {
            self.push(&format!(" xmlns:xsi=\"{XSI}\""));
        }
        if let Some(namespace) = element.namespace {
            self.push(&format!(" xmlns=\"{namespace}\""));
        }
        for attribute in element.attributes.iter().filter(|attribute| is_written(attribute)) {
            self.push(" ");
            self.attribute(attribute, known(attribute.name).as_deref());
        }
        self.content(file, element, indent, known);
    }

    /// An element around others.
    pub(super) fn list(&mut self, angle: &str, name: &str) {
        self.push(&format!("{angle}{name}>\n  "));
        self.last();
        self.push(&format!("\n</{name}>"));
    }

    /// Written XML in which each value is a place to fill in, and each index is `index`.
    pub(super) fn filled(&mut self, written: &str, index: &str) {
        let mut rest = written;
        while let Some((before, behind)) = rest.split_once("=\"") {
            let Some((value, after)) = behind.split_once('"') else { break };
            self.push(before);
            self.push("=\"");
            self.place(if before.ends_with(" index") { index } else { value });
            self.push("\"");
            rest = after;
        }
        self.push(rest);
    }

    fn content(&mut self, file: FileKind, element: &Element, indent: &str, known: &dyn Fn(&str) -> Option<String>) {
        let inner = format!("{indent}  ");
        let mandatory = MANDATORY.iter().find(|(of, name, _)| *of == file && *name == element.name);
        let around = |snippet: &mut Self, before: &str, after: &str| {
            snippet.push(before);
            snippet.last();
            snippet.push(after);
            snippet.push(&format!("</{}>", element.name));
        };
        match (mandatory, element.name) {
            (Some((.., children)), _) => {
                self.push(">");
                for child in children.iter().filter_map(|child| files::find(file, child)) {
                    self.push(&format!("\n{inner}<"));
                    self.element(file, child, &inner, known);
                }
                self.push(&format!("\n{indent}</{}>", element.name));
            }
            (None, "Code") => around(self, "><![CDATA[begin\n  ", "\nend]]>"),
            (None, "code") => around(self, ">begin\n  ", "\nend\n"),
            (None, "Description") => around(self, "><![CDATA[", "]]>"),
            (None, "description") => around(self, ">", ""),
            // A variable has its defaults without any values.
            (None, _) if element.children.is_empty() || !element.attributes.is_empty() => self.push(" />"),
            (None, _) => around(self, &format!(">\n{inner}"), &format!("\n{indent}")),
        }
    }
}

fn is_written(attribute: &Attribute) -> bool {
    !LEFT_OUT.contains(&attribute.name) || matches!(attribute.presence, Presence::Expected(_))
}
