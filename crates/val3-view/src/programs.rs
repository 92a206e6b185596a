//! Code of loaded programs, for pages.

use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_vm::Space;

use crate::code::{Code, codes};
use crate::lines::Lines;
use crate::wire::{ProgramCode, ProgramsMessage};

/// Applications and libraries whose programs the pages have.
#[derive(Debug, Default)]
pub(crate) struct Programs {
    known: Vec<Arc<Image>>,
}

impl Programs {
    /// Returns the programs of applications and libraries that were loaded since the last call. A library that is loaded
    /// again from the same files has no message. `t` is the present time in seconds.
    pub(crate) fn news(&mut self, t: f64, space: &Space, lines: &mut Lines) -> Vec<ProgramsMessage> {
        let is_known = |image: &Arc<Image>| self.known.iter().any(|known| Arc::ptr_eq(known, image));
        let images = || space.loaded().map(|(_, instance)| &instance.image);
        if images().all(is_known) {
            return Vec::new();
        }
        let new: Vec<Arc<Image>> = images().filter(|image| !is_known(image)).map(Arc::clone).collect();
        self.known = images().map(Arc::clone).collect();
        new.iter().filter_map(|image| message(t, image, lines)).collect()
    }
}

/// Returns the programs in new and changed files; `None` without such programs.
fn message(t: f64, image: &Image, lines: &mut Lines) -> Option<ProgramsMessage> {
    let files = (0..).zip(&image.files).filter(|(_, file)| lines.reload(file)).collect::<Vec<(u32, &String)>>();
    let mut programs = Vec::new();
    for (number, file) in files {
        let own: Vec<&Program> = image.programs.iter().filter(|program| program.file == number).collect();
        if let Some(text) = lines.text(file).filter(|_| !own.is_empty()) {
            programs.extend(of_file(file, text, &own));
        }
    }
    (!programs.is_empty()).then(|| ProgramsMessage { t, application: image.name.clone(), programs })
}

fn of_file(file: &str, text: &str, programs: &[&Program]) -> Vec<ProgramCode> {
    let codes = codes(text);
    let code = |program: &&Program| {
        let Code { line, lines } = of_program(program, &codes)?.clone();
        Some(ProgramCode { name: program.name.clone(), file: file.to_owned(), line, code: lines })
    };
    programs.iter().filter_map(code).collect()
}

/// Returns the code with the first line of a program.
fn of_program<'c>(program: &Program, codes: &'c [Code]) -> Option<&'c Code> {
    match (codes, program.lines.first().or(program.closings.first())) {
        ([code], _) => Some(code),
        (codes, Some(first)) => codes.iter().find(|code| code.contains(first.row)),
        (_, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use val3_tests::running::Running;

    use super::*;

    thread_local! {
        static CODE: Cell<&'static str> = const { Cell::new("delay(1)") };
    }

    /// Reads the program `start` only.
    fn read(file: &str) -> Option<String> {
        let code = CODE.get();
        let text = format!("<Programs>\n<Program name=\"start\"><Code>begin\n{code}\nend</Code></Program></Programs>");
        file.ends_with("start.pgx").then_some(text)
    }

    #[test]
    fn programs_are_sent_again_after_a_change_of_their_file() {
        let controller = Running::start("program start()\nbegin\n  delay(1)\nend\n").controller;
        let space = &controller.vm.space;
        let mut lines = Lines::new(read);
        let mut programs = Programs::default();
        let sent = programs.news(0.5, space, &mut lines);
        let names = |message: &ProgramsMessage| {
            message.programs.iter().map(|program| (program.name.clone(), program.line)).collect::<Vec<_>>()
        };
        assert_eq!(sent.iter().map(names).collect::<Vec<_>>(), [[("start".to_owned(), 2)]]);
        assert_eq!(sent[0].t, 0.5);
        assert_eq!(programs.news(1.0, space, &mut lines), []);
        let load_again = |lines: &mut Lines| Programs::default().news(1.5, space, lines);
        assert_eq!(load_again(&mut lines), []);
        CODE.set("delay(2)");
        assert_eq!(load_again(&mut lines).iter().map(|message| message.t).collect::<Vec<_>>(), [1.5]);
        assert_eq!(lines.code(&sent[0].programs[0].file, 3).as_deref(), Some("delay(2)"));
    }

    #[test]
    fn programs_of_one_file_are_found_by_their_lines() {
        let text = "<Programs><Program><Code>begin\nend</Code></Program>\n<Program><Code>begin\n\nend</Code></Program></Programs>";
        let at = |row| {
            let closing = val3_bytecode::SourceLine { op: 0, range: val3_bytecode::SourceRange::default(), row };
            of_program(&Program { closings: vec![closing], ..Program::default() }, &codes(text)).map(|code| code.line)
        };
        assert_eq!([1, 2, 3, 5, 6].map(at), [Some(1), Some(1), Some(3), Some(3), None]);
    }
}
