//! Parses the lines of a listing.

use crate::declaration::{self, Data, Head, Shape};

/// Content of a listing.
#[derive(Debug, Default)]
pub(crate) struct Listing {
    pub(crate) projects: Vec<Project>,
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
pub(crate) struct Project {
    /// Folder in `usrapp`.
    pub(crate) folder: String,
    pub(crate) version: Numbered<String>,
    pub(crate) data: Vec<Numbered<Data>>,
    pub(crate) libraries: Vec<Numbered<Reference>>,
    pub(crate) types: Vec<Numbered<Reference>>,
    pub(crate) programs: Vec<Program>,
}

/// `library name "path"` or `type name "path"`.
#[derive(Debug)]
pub(crate) struct Reference {
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) autoload: bool,
}

/// A program; the code includes `begin` and `end`.
#[derive(Debug)]
pub(crate) struct Program {
    pub(crate) head: Numbered<Head>,
    pub(crate) locals: Vec<Numbered<Data>>,
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
    let mut reader = Reader { listing: Listing::default(), state: State::Project, comments: Vec::new() };
    reader.listing.projects.push(Project::new("main"));
    for (index, line) in text.lines().enumerate() {
        reader.line(index + 1, line);
    }
    let mut listing = reader.listing;
    if listing.projects.len() + listing.files.len() > 1 {
        listing.projects.retain(|project| project.folder != "main" || !project.is_empty());
    }
    listing.projects.iter_mut().for_each(Project::complete_start);
    listing
}

impl Project {
    fn new(folder: &str) -> Project {
        Project {
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
    fn start(&mut self, number: usize) -> &mut Program {
        let index = self.programs.iter().position(|program| program.head.content.name == "start");
        let index = index.unwrap_or_else(|| {
            let head = Head { public: false, name: "start".to_owned(), parameters: Vec::new() };
            self.programs.push(Program { head: Numbered { number, content: head }, locals: vec![], code: vec![] });
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
enum State {
    Project,
    Locals,
    Code,
    RawFile,
}

struct Reader {
    listing: Listing,
    state: State,
    /// Comments that belong to the next line, if it is code.
    comments: Vec<Numbered<String>>,
}

impl Reader {
    #[track_caller]
    fn line(&mut self, number: usize, line: &str) {
        if let Some(path) = line.strip_prefix("=== ") {
            self.listing.files.push(RawFile { path: raw_path(path.trim()), lines: Vec::new() });
            self.state = State::RawFile;
        } else if let Some(folder) = line.strip_prefix("--- ") {
            self.listing.projects.push(Project::new(folder.trim()));
            self.state = State::Project;
        } else {
            match self.state {
                State::Project => self.project_line(number, line),
                State::Locals => self.local_line(number, line),
                State::Code => self.code_line(number, line),
                State::RawFile => self.raw_line(number, line),
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
            self.project().programs.push(Program { head, locals: Vec::new(), code: Vec::new() });
            self.state = State::Locals;
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
            self.state = State::Code;
            self.code_line(number, line);
        } else if !text.is_empty() && !text.starts_with("//") {
            let types: Vec<String> = self.project().types.iter().map(|it| it.content.name.clone()).collect();
            let Some(local) = declaration::data(text, &types) else {
                panic!("line {number} of the listing, `{text}`: expected a local or `begin`")
            };
            assert!(local.value.is_none(), "line {number} of the listing, `{text}`: a local has no initial value");
            let has_keys = matches!(&local.shape, Shape::Collection(keys) if !keys.is_empty());
            assert!(!has_keys, "line {number} of the listing, `{text}`: a local collection has no keys");
            self.program().locals.push(Numbered { number, content: local });
        }
    }

    fn code_line(&mut self, number: usize, line: &str) {
        self.program().code.push(Numbered { number, content: line.to_owned() });
        if first_word_is(line, "end") {
            self.state = State::Project;
        }
    }

    fn raw_line(&mut self, number: usize, line: &str) {
        if let Some(file) = self.listing.files.last_mut() {
            file.lines.push(Numbered { number, content: line.to_owned() });
        }
    }

    fn project(&mut self) -> &mut Project {
        self.listing.projects.last_mut().expect("a listing begins with its first project")
    }

    fn program(&mut self) -> &mut Program {
        self.project().programs.last_mut().expect("locals and code follow a program's head")
    }
}

/// Path of a raw file: `/x` is in `usr`, other paths are in `usr/usrapp`.
fn raw_path(path: &str) -> String {
    path.strip_prefix('/').map_or_else(|| format!("usrapp/{path}"), str::to_owned)
}

#[track_caller]
fn reference(text: &str, keyword: &str) -> Option<Reference> {
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
    Some(Reference { name: name.trim().to_owned(), path: path.to_owned(), autoload })
}

fn first_word_is(line: &str, keyword: &str) -> bool {
    declaration::word(line.trim()).is_some_and(|(word, _)| word.eq_ignore_ascii_case(keyword))
}
