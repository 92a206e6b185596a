//! A page and its kind of subject.

/// A page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// Kind of the subject.
    pub kind: TopicKind,
    /// Heading of the group within the kind; empty if the kind has no groups.
    pub group: &'static str,
    /// Words that find the page. The first word is listed.
    pub names: Vec<String>,
    /// File name of the page in the book, without extension.
    pub stem: String,
    /// Title in a table of contents.
    pub title: String,
    /// One-line description.
    pub summary: String,
    /// Page in Markdown.
    pub page: String,
}

/// Kind of a page's subject, in the order of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum TopicKind {
    /// A rule of `val3 check`.
    Finding,
    /// A keyword of the language.
    Statement,
    /// An instruction.
    Instruction,
    /// A type that variables can have.
    Type,
    /// A field of a type, or an attribute of values in data files.
    Field,
    /// An operator, or several similar operators.
    Operator,
    /// A term of robots and controllers.
    Word,
    /// A run-time error.
    RuntimeError,
    /// A result of `libLoad` and similar instructions.
    LibraryError,
    /// A message of the controller's event log.
    LogMessage,
}

impl TopicKind {
    /// All kinds, in the order of the list.
    pub const ALL: [Self; 10] = [
        Self::Finding,
        Self::Statement,
        Self::Instruction,
        Self::Type,
        Self::Field,
        Self::Operator,
        Self::Word,
        Self::RuntimeError,
        Self::LibraryError,
        Self::LogMessage,
    ];

    /// Heading for a list of such pages.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Finding => "Findings of val3 check",
            Self::Statement => "Statements",
            Self::Instruction => "Instructions",
            Self::Type => "Types",
            Self::Field => "Fields",
            Self::Operator => "Operators",
            Self::Word => "Words of robots and controllers",
            Self::RuntimeError => "Run-time errors",
            Self::LibraryError => "Results of library instructions",
            Self::LogMessage => "Messages of the controller's log",
        }
    }

    /// Folder of such pages in the book.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Finding => "rules",
            Self::Statement => "statements",
            Self::Instruction => "instructions",
            Self::Type => "types",
            Self::Field => "fields",
            Self::Operator => "operators",
            Self::Word => "words",
            Self::RuntimeError => "errors",
            Self::LibraryError => "library-results",
            Self::LogMessage => "log-messages",
        }
    }
}

impl Topic {
    /// First name.
    pub fn name(&self) -> &str {
        self.names.first().map_or("", String::as_str)
    }
}

/// Appends the section of the manual to a description, if there is one.
pub(super) fn sourced(what: &str, section: &str) -> String {
    if section.is_empty() { what.to_owned() } else { format!("{what}, manual {section}") }
}

/// File name of a page, in which special characters are replaced by words.
pub(super) fn stem(name: &str) -> String {
    let signs = [("$", "addon-"), ("?", "print"), ("//", "comment"), ("=", "assignment")];
    signs.iter().fold(name.to_owned(), |name, (sign, word)| name.replace(sign, word))
}
