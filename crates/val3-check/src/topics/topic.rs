//! A page, and the kind of its subject.

/// One page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Topic {
    /// The kind of its subject.
    pub kind: Kind,
    /// The heading of the pages that are listed together within the kind; empty if the kind has no groups.
    pub group: &'static str,
    /// The words that find it. The first one is listed.
    pub names: Vec<String>,
    /// The name of its page in the book, without an extension.
    pub stem: String,
    /// The title in a table of contents.
    pub title: String,
    /// A description of one line.
    pub summary: String,
    /// The page in Markdown.
    pub page: String,
}

/// The kind of a page's subject, in the order of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
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
    /// An operator, or several of one kind.
    Operator,
    /// A word of robots and controllers.
    Word,
    /// A run-time error.
    RuntimeError,
    /// A result of `libLoad` and similar instructions.
    LibraryError,
    /// A message of the controller's event log.
    LogMessage,
}

impl Kind {
    /// Every kind, in the order of the list.
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

    /// The heading of a list of such pages.
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

    /// The folder of the book that holds such pages.
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
    /// The first name.
    pub fn name(&self) -> &str {
        self.names.first().map_or("", String::as_str)
    }
}

/// A description with its section of the manual, if there is one.
pub(super) fn sourced(what: &str, section: &str) -> String {
    if section.is_empty() { what.to_owned() } else { format!("{what}, manual {section}") }
}

/// A page file for a name. Special characters are written as words.
pub(super) fn stem(name: &str) -> String {
    let signs = [("$", "addon-"), ("?", "print"), ("//", "comment"), ("=", "assignment")];
    signs.iter().fold(name.to_owned(), |name, (sign, word)| name.replace(sign, word))
}
