//! Code of loaded programs, for pages.

use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_machine::controller::Controller;
use val3_machine::devices::ReplacedLines;
use val3_machine::event::seconds;

use crate::code::{Code, codes};
use crate::lines::Lines;
use crate::wire::{ProgramCode, ProgramsMessage};

/// Applications and libraries whose programs the pages have.
#[derive(Debug, Default)]
pub(crate) struct Programs {
    known: Vec<Arc<Image>>,
}

impl Programs {
    /// Returns the programs of applications and libraries that were loaded, or have a replaced line, since the last call. A
    /// library that is loaded again from the same files has no message.
    pub(crate) fn news(&mut self, controller: &Controller, lines: &mut Lines) -> Vec<ProgramsMessage> {
        let is_known = |image: &Arc<Image>| self.known.iter().any(|known| Arc::ptr_eq(known, image));
        let loaded = || controller.vm.space.loaded().map(|(id, instance)| (id, &instance.image));
        if loaded().all(|(_, image)| is_known(image)) {
            return Vec::new();
        }
        let t = seconds(controller.now());
        let new = loaded().filter(|(_, image)| !is_known(image));
        let messages = new.filter_map(|(id, image)| message(t, image, &controller.devices.replaced_lines(id), lines));
        let messages = messages.collect();
        self.known = loaded().map(|(_, image)| Arc::clone(image)).collect();
        messages
    }
}

/// Returns the programs in the new and changed files of an image; `None` without such programs.
fn message(t: f64, image: &Image, replaced: &ReplacedLines, lines: &mut Lines) -> Option<ProgramsMessage> {
    let files = (0..).zip(&image.files).filter(|(_, file)| reload(file, replaced, lines));
    let files = files.collect::<Vec<(u32, &String)>>();
    let mut programs = Vec::new();
    for (number, file) in files {
        let own: Vec<&Program> = image.programs.iter().filter(|program| program.file == number).collect();
        let code = lines.text(file).filter(|_| !own.is_empty()).map(codes);
        if let Some(mut code) = code {
            lines.replaced(file).for_each(|(row, line)| code.iter_mut().for_each(|code| code.replace(*row, line)));
            programs.extend(own.iter().filter_map(|program| program_code(program, file, &code)));
        }
    }
    (!programs.is_empty()).then(|| ProgramsMessage { t, application: image.name.clone(), programs })
}

/// Reads a file and its replaced lines. Returns whether one of them differs from the previous version.
fn reload(file: &str, replaced: &ReplacedLines, lines: &mut Lines) -> bool {
    let own = replaced.iter().filter(|((known, _), _)| known == file);
    let is_replaced = lines.replace(file, own.map(|((_, row), code)| (*row, code.clone())).collect());
    lines.reload(file) || is_replaced
}

/// Returns a program with its code, for pages; `None` if no code in the file contains the first line of the program.
fn program_code(program: &Program, file: &str, codes: &[Code]) -> Option<ProgramCode> {
    let Code { line, lines } = of_program(program, codes)?.clone();
    Some(ProgramCode { name: program.name.clone(), file: file.to_owned(), line, code: lines })
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
    use val3_vm::{LineReplacement, ProgramId};

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
        let mut controller = Running::start("program start()\nbegin\n  delay(1)\nend\n").controller;
        let mut lines = Lines::new(read);
        let mut programs = Programs::default();
        let sent = programs.news(&controller, &mut lines);
        let names = |message: &ProgramsMessage| {
            message.programs.iter().map(|program| (program.name.clone(), program.line)).collect::<Vec<_>>()
        };
        assert_eq!(sent.iter().map(names).collect::<Vec<_>>(), [[("start".to_owned(), 2)]]);
        assert_eq!(sent[0].t, 0.0);
        assert_eq!(programs.news(&controller, &mut lines), []);
        while controller.now() == 0 {
            controller.step();
        }
        let load_again = |lines: &mut Lines| Programs::default().news(&controller, lines);
        assert_eq!(load_again(&mut lines), []);
        CODE.set("delay(2)");
        let times: Vec<f64> = load_again(&mut lines).iter().map(|message| message.t).collect();
        assert_eq!(times, [seconds(controller.now())]);
        assert_eq!(lines.code(&sent[0].programs[0].file, 3).as_deref(), Some("delay(2)"));
    }

    #[test]
    fn a_replaced_line_is_sent_with_its_program() {
        let mut controller = Running::start("program start()\nbegin\n  delay(1)\nend\n").controller;
        let (mut lines, mut programs) = (Lines::new(read), Programs::default());
        let file = programs.news(&controller, &mut lines).remove(0).programs.remove(0).file;
        assert_eq!(lines.code(&file, 3).as_deref(), Some(CODE.get()));
        let (instance, image) =
            controller.vm.space.loaded().map(|(id, found)| (id, Image::clone(&found.image))).next().unwrap();
        let replacement =
            LineReplacement { program: ProgramId { instance, number: 0 }, row: 3, image: Arc::new(image) };
        controller.replace_line(replacement, "  delay(nA[nB[0]]>1)").unwrap();
        let sent = programs.news(&controller, &mut lines);
        let line: String = sent[0].programs[0].code[1].iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(line, "  delay(nA[nB[0]]>1)");
        assert_eq!(lines.code(&file, 3).as_deref(), Some("delay(nA[nB[0]]>1)"));
        assert_eq!(programs.news(&controller, &mut lines), []);
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
