//! Snippets of elements and attributes.

use val3_lang::files::{self, AttributePage, ElementPage, FileKind, Presence};

/// Attributes that the controller's files omit if they have their default.
const LEFT_OUT: [&str; 6] = ["autoload", "password", "access", "use", "dimensions", "privilege"];

/// Child elements without which an element is useless.
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

/// Root elements that declare the namespace prefix `xsi`.
const WITH_XSI: [&str; 2] = ["Database", "Programs"];
const XSI: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// A text with placeholders, and the same text without them.
#[derive(Debug, Default)]
pub(super) struct Snippet {
    pub(super) text: String,
    pub(super) plain: String,
    places: u32,
    has_last: bool,
}

impl Snippet {
    /// Appends plain text.
    pub(super) fn push(&mut self, text: &str) {
        self.text += &text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}");
        self.plain += text;
    }

    /// Appends a placeholder with a default text.
    pub(super) fn place(&mut self, text: &str) {
        self.places += 1;
        let escaped = text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}");
        self.text += &format!("${{{}:{escaped}}}", self.places);
        self.plain += text;
    }

    /// Appends a placeholder with choices; the first choice is the default.
    fn choice(&mut self, words: &[&str]) {
        self.places += 1;
        self.text += &format!("${{{}|{}|}}", self.places, words.join(","));
        self.plain += words.first().unwrap_or(&"");
    }

    /// Marks the final cursor position.
    fn last(&mut self) {
        if !self.has_last {
            self.text += "$0";
            self.has_last = true;
        }
        // Without placeholders, the line would be blank.
        if let Some(before) = self.plain.trim_end_matches(' ').strip_suffix('\n') {
            self.plain.truncate(before.len());
        }
    }

    /// Appends ` name="value"` with a placeholder for the value; `known` is its default if it is known.
    pub(super) fn attribute(&mut self, attribute: &AttributePage, known: Option<&str>) {
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

    /// Appends a new element without its first `<`; `indent` is inserted before its further lines. `known` returns
    /// values that are more likely than the defaults.
    pub(super) fn element(
        &mut self,
        file: FileKind,
        element: &ElementPage,
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

    /// Appends an element that contains the final cursor position.
    pub(super) fn list(&mut self, angle: &str, name: &str) {
        self.push(&format!("{angle}{name}>\n  "));
        self.last();
        self.push(&format!("\n</{name}>"));
    }

    /// Appends XML in which each value becomes a placeholder, and each index becomes `index`.
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

    fn content(&mut self, file: FileKind, element: &ElementPage, indent: &str, known: &dyn Fn(&str) -> Option<String>) {
        let inner = format!("{indent}  ");
        let mandatory = MANDATORY.iter().find(|(of, name, _)| *of == file && *name == element.name);
        match (mandatory, element.name) {
            (Some((.., children)), _) => {
                self.push(">");
                for child in children.iter().filter_map(|child| files::find(file, child)) {
                    self.push(&format!("\n{inner}<"));
                    self.element(file, child, &inner, known);
                }
                self.push(&format!("\n{indent}</{}>", element.name));
            }
            (None, "Code") => self.around("><![CDATA[begin\n  ", "\nend]]></Code>"),
            (None, "code") => self.around(">begin\n  ", "\nend\n</code>"),
            (None, "Description") => self.around("><![CDATA[", "]]></Description>"),
            (None, "description") => self.around(">", "</description>"),
            // A variable without values has its defaults.
            (None, _) if element.children.is_empty() || !element.attributes.is_empty() => self.push(" />"),
            (None, name) => self.around(&format!(">\n{inner}"), &format!("\n{indent}</{name}>")),
        }
    }

    /// Appends the two texts with the final cursor position between them.
    fn around(&mut self, before: &str, after: &str) {
        self.push(before);
        self.last();
        self.push(after);
    }
}

fn is_written(attribute: &AttributePage) -> bool {
    !LEFT_OUT.contains(&attribute.name) || matches!(attribute.presence, Presence::Expected(_))
}
