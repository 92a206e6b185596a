//! Parts that all applications share: inputs and outputs, a user type, and a library with programs.

use super::model::{Container, Data, Parameter, Program, Project, ReferencedProject, Signature, Type, Variable};

/// The user type.
pub(super) const SLOT: ReferencedProject = ReferencedProject { name: "Slot", folder: "types/Slot" };
/// The inputs and outputs.
pub(super) const IO: ReferencedProject = ReferencedProject { name: "io", folder: "io" };
/// The library with programs.
pub(super) const LOGBOOK: ReferencedProject = ReferencedProject { name: "logbook", folder: "logbook" };

/// Number of digital signals in each direction.
pub(super) const SIGNALS: usize = 16;

/// Returns the three projects.
pub(super) fn projects() -> Vec<Project> {
    vec![io(), slot(), logbook()]
}

fn io() -> Project {
    let data = ["dIn", "dOut"].map(|name| public(name, Type::Dio, Container::Array(SIGNALS)));
    project(IO, data.to_vec(), Vec::new())
}

fn slot() -> Project {
    let data = vec![
        public("pPlace", Type::Point, Container::One),
        public("nCount", Type::Num, Container::One),
        public("nSize", Type::Num, Container::Array(3)),
        public("sLabel", Type::Text, Container::One),
        public("bFull", Type::Bool, Container::One),
    ];
    project(SLOT, data, Vec::new())
}

fn logbook() -> Project {
    let data = vec![
        public("nEntries", Type::Num, Container::One),
        public("sLast", Type::Text, Container::One),
        public("bVerbose", Type::Bool, Container::One),
    ];
    let note = program(
        note_signature("note"),
        &[
            "begin",
            "  nEntries=nEntries+1",
            "  sLast=x_sText",
            "  if bVerbose or x_nLevel>2",
            "    logMsg(x_sText)",
            "  endIf",
            "end",
        ],
    );
    let count = program(count_signature("count"), &["begin", "  x_nTotal=nEntries", "end"]);
    project(LOGBOOK, data, vec![note, count])
}

/// Returns the programs that an application can call.
pub(super) fn library_programs() -> Vec<Signature> {
    vec![note_signature("logbook:note"), count_signature("logbook:count")]
}

fn note_signature(name: &str) -> Signature {
    let level = Parameter { variable: Variable::one("x_nLevel", Type::Num), by_reference: false };
    let text = Parameter { variable: Variable::one("x_sText", Type::Text), by_reference: false };
    Signature { name: name.to_owned(), parameters: vec![level, text] }
}

fn count_signature(name: &str) -> Signature {
    let total = Parameter { variable: Variable::one("x_nTotal", Type::Num), by_reference: true };
    Signature { name: name.to_owned(), parameters: vec![total] }
}

fn public(name: &str, ty: Type, container: Container) -> Data {
    Data { variable: Variable { name: name.to_owned(), ty, container }, public: true }
}

fn program(signature: Signature, lines: &[&str]) -> Program {
    let lines = lines.iter().map(|line| (*line).to_owned()).collect();
    Program { signature, public: true, locals: Vec::new(), lines }
}

fn project(reference: ReferencedProject, data: Vec<Data>, programs: Vec<Program>) -> Project {
    Project {
        name: reference.name.to_owned(),
        folder: reference.folder.to_owned(),
        data,
        programs,
        libraries: Vec::new(),
        types: Vec::new(),
    }
}
