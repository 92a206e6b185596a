//! Parses the lines of a listing.

use crate::declaration::{self, FixtureBrackets, FixtureData, Head};

/// Content of a listing.
#[derive(Debug, Default)]
pub(crate) struct Listing {
    pub(crate) projects: Vec<ListedProject>,
    pub(crate) files: Vec<RawFile>,
}

/// A raw file, whose text is used unchanged.
#[derive(Debug)]
pub(crate) struct RawFile {
    /// Path relative to the `usr` folder.
    pub(crate) path: String,
    pub(crate) lines: Vec<Numbered<String>>,
}

/// An application, library or type.
#[derive(Debug)]
pub(crate) struct ListedProject {
    /// Folder in `usrapp`.
    pub(crate) folder: String,
    pub(crate) version: Numbered<String>,
    pub(crate) data: Vec<Numbered<FixtureData>>,
    pub(crate) libraries: Vec<Numbered<ListedReference>>,
    pub(crate) types: Vec<Numbered<ListedReference>>,
    pub(crate) programs: Vec<ListedProgram>,
}

/// `library name "path"` or `type name "path"`.
#[derive(Debug)]
pub(crate) struct ListedReference {
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) autoload: bool,
}

/// A program; the code includes `begin` and `end`.
#[derive(Debug)]
pub(crate) struct ListedProgram {
    pub(crate) head: Numbered<Head>,
    pub(crate) locals: Vec<Numbered<FixtureData>>,
    pub(crate) code: Vec<Numbered<String>>,
}

/// A part of a listing with its line number, from 1; 0 if it is generated.
#[derive(Debug)]
pub(crate) struct Numbered<T> {
    pub(crate) number: usize,
    pub(crate) content: T,
}

/// Parses a listing without common indentation.
#[track_caller]
pub(crate) fn read(text: &str) -> Listing {
    let mut reader =
        FixtureReader { listing: Listing::default(), state: ListingSection::Project, comments: Vec::new() };
    reader.listing.projects.push(ListedProject::new("main"));
    for (index, line) in text.lines().enumerate() {
        reader.line(index + 1, line);
    }
    let mut listing = reader.listing;
    if listing.projects.len() + listing.files.len() > 1 {
        listing.projects.retain(|project| project.folder != "main" || !project.is_empty());
    }
    listing.projects.iter_mut().for_each(ListedProject::complete_start);
    listing
}

impl ListedProject {
    fn new(folder: &str) -> ListedProject {
        ListedProject {
            folder: folder.to_owned(),
            version: Numbered { number: 0, content: "s7.11".to_owned() },
            data: Vec::new(),
            libraries: Vec::new(),
            types: Vec::new(),
            programs: Vec::new(),
        }
    }

    fn is_empty(&self) -> bool {
        self.data.is_empty() && self.libraries.is_empty() && self.types.is_empty() && self.programs.is_empty()
    }

    /// Program for lines outside of `program … end`.
    fn start(&mut self, number: usize) -> &mut ListedProgram {
        let index = self.programs.iter().position(|program| program.head.content.name == "start");
        let index = index.unwrap_or_else(|| {
            let head = Head { public: false, name: "start".to_owned(), parameters: Vec::new() };
            self.programs.push(ListedProgram {
                head: Numbered { number, content: head },
                locals: vec![],
                code: vec![],
            });
            self.programs.len() - 1
        });
        &mut self.programs[index]
    }

    /// Adds `begin` and `end` to the program of loose lines.
    fn complete_start(&mut self) {
        for program in &mut self.programs {
            if !program.code.iter().any(|line| first_word_is(&line.content, "begin")) {
                program.code.insert(0, Numbered { number: 0, content: "begin".to_owned() });
                program.code.push(Numbered { number: 0, content: "end".to_owned() });
            }
        }
    }
}

/// Part of the listing to which the next line belongs.
enum ListingSection {
    Project,
    Locals,
    Code,
    RawFile,
}

struct FixtureReader {
    listing: Listing,
    state: ListingSection,
    /// Comments that belong to the next line, if it is code.
    comments: Vec<Numbered<String>>,
}

impl FixtureReader {
    #[track_caller]
    fn line(&mut self, number: usize, line: &str) {
        if let Some(path) = line.strip_prefix("=== ") {
            self.listing.files.push(RawFile { path: raw_path(path.trim()), lines: Vec::new() });
            self.state = ListingSection::RawFile;
        } else if let Some(folder) = line.strip_prefix("--- ") {
            self.listing.projects.push(ListedProject::new(folder.trim()));
            self.state = ListingSection::Project;
        } else {
            match self.state {
                ListingSection::Project => self.project_line(number, line),
                ListingSection::Locals => self.local_line(number, line),
                ListingSection::Code => self.code_line(number, line),
                ListingSection::RawFile => self.raw_line(number, line),
            }
        }
    }

    #[track_caller]
    fn project_line(&mut self, number: usize, line: &str) {
        let text = line.trim();
        if text.is_empty() || text.starts_with("//") {
            self.comments.push(Numbered { number, content: line.to_owned() });
            return;
        }
        let comments = std::mem::take(&mut self.comments);
        if let Some(head) = declaration::head(text) {
            let head = Numbered { number, content: head };
            self.project().programs.push(ListedProgram { head, locals: Vec::new(), code: Vec::new() });
            self.state = ListingSection::Locals;
        } else if !self.declaration(number, text) {
            let start = self.project().start(number);
            start.code.extend(comments);
            start.code.push(Numbered { number, content: line.to_owned() });
        }
    }

    /// Parses a declaration, if `text` is one. Returns whether it is.
    #[track_caller]
    fn declaration(&mut self, number: usize, text: &str) -> bool {
        let project = self.project();
        let types: Vec<String> = project.types.iter().map(|it| it.content.name.clone()).collect();
        if let Some(library) = reference(text, "library ") {
            project.libraries.push(Numbered { number, content: library });
        } else if let Some(ty) = reference(text, "type ") {
            project.types.push(Numbered { number, content: ty });
        } else if let Some(version) = text.strip_prefix("version ") {
            project.version = Numbered { number, content: version.trim().to_owned() };
        } else if let Some(data) = declaration::data(text, &types) {
            project.data.push(Numbered { number, content: data });
        } else {
            return false;
        }
        true
    }

    #[track_caller]
    fn local_line(&mut self, number: usize, line: &str) {
        let text = line.trim();
        if first_word_is(text, "begin") {
            self.state = ListingSection::Code;
            self.code_line(number, line);
        } else if !text.is_empty() && !text.starts_with("//") {
            let types: Vec<String> = self.project().types.iter().map(|it| it.content.name.clone()).collect();
            let Some(local) = declaration::data(text, &types) else {
                panic!("line {number} of the listing, `{text}`: expected a local or `begin`")
            };
            assert!(local.value.is_none(), "line {number} of the listing, `{text}`: a local has no initial value");
            let has_keys = matches!(&local.shape, FixtureBrackets::Collection(keys) if !keys.is_empty());
            assert!(!has_keys, "line {number} of the listing, `{text}`: a local collection has no keys");
            self.program().locals.push(Numbered { number, content: local });
        }
    }

    fn code_line(&mut self, number: usize, line: &str) {
        self.program().code.push(Numbered { number, content: line.to_owned() });
        if first_word_is(line, "end") {
            self.state = ListingSection::Project;
        }
    }

    fn raw_line(&mut self, number: usize, line: &str) {
        if let Some(file) = self.listing.files.last_mut() {
            file.lines.push(Numbered { number, content: line.to_owned() });
        }
    }

    fn project(&mut self) -> &mut ListedProject {
        self.listing.projects.last_mut().expect("a listing begins with its first project")
    }

    fn program(&mut self) -> &mut ListedProgram {
        self.project().programs.last_mut().expect("locals and code follow a program's head")
    }
}

/// Path of a raw file: `/x` is in `usr`, other paths are in `usr/usrapp`.
fn raw_path(path: &str) -> String {
    path.strip_prefix('/').map_or_else(|| format!("usrapp/{path}"), str::to_owned)
}

#[track_caller]
fn reference(text: &str, keyword: &str) -> Option<ListedReference> {
    let rest = text.strip_prefix(keyword)?;
    let mut parts = rest.split('"');
    let (Some(name), Some(path), Some(options)) = (parts.next(), parts.next(), parts.next()) else {
        panic!("`{text}`: write `{keyword}name \"path\"`")
    };
    let autoload = match options.trim() {
        "" | "autoload=true" => true,
        "autoload=false" => false,
        other => panic!("`{text}`: `{other}` is no option of a library"),
    };
    Some(ListedReference { name: name.trim().to_owned(), path: path.to_owned(), autoload })
}

fn first_word_is(line: &str, keyword: &str) -> bool {
    declaration::word(line.trim()).is_some_and(|(word, _)| word.eq_ignore_ascii_case(keyword))
}
