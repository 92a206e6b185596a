//! Lines of programs by the names of the interface.

use std::sync::Arc;

use val3_bytecode::{Image, Program};
use val3_debug::TaskFrame;
use val3_lang::ports::TaskNumber;
use val3_soap::v2::ProgramLine;
use val3_soap::{ExceptionCode, SoapFault};
use val3_vm::{InstanceId, ProgramId};

use crate::applications;
use crate::context::{ServiceTarget, refused};
use crate::inferred::is_project_name;

/// Line of a program in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct FileLine {
    /// File of the program.
    pub(crate) file: String,
    /// Row of the file, from 1.
    pub(crate) row: u32,
}

impl ServiceTarget<'_> {
    /// Line that a stack frame executes.
    pub(crate) fn line_of(&self, frame: &TaskFrame) -> ProgramLine {
        let instance = self.debugger.controller.vm.space.instance(frame.instance);
        let line = self.evaluator.code_line(&frame.file, frame.row);
        let number = line.as_ref().and_then(|line| i32::try_from(line.number).ok());
        ProgramLine {
            project: instance.map(applications::project_name),
            program: Some(frame.program.clone()),
            // A library that the application does not reference has no known code.
            number: number.unwrap_or_default(),
            content: line.map(|line| line.text),
        }
    }

    /// Line that a task executes; without names if it has ended.
    pub(crate) fn line_of_task(&self, task: TaskNumber) -> ProgramLine {
        let frames = val3_debug::frames(&self.debugger.controller.vm, task);
        let none = ProgramLine { project: None, program: None, number: 0, content: None };
        frames.first().map_or(none, |frame| self.line_of(frame))
    }

    /// Finds a line of a program in memory. Code in the reference must be the code in memory, apart from indentation.
    ///
    /// # Errors
    /// The application, program or line is not in memory, or the line has other code.
    pub(crate) fn find_line(&self, line: &ProgramLine) -> Result<FileLine, SoapFault> {
        self.find_program_line(line).map(|(_, line)| line)
    }

    /// Like [`find_line`](Self::find_line), with the program.
    ///
    /// # Errors
    /// Like [`find_line`](Self::find_line).
    pub(crate) fn find_program_line(&self, line: &ProgramLine) -> Result<(ProgramId, FileLine), SoapFault> {
        let instance = self.instance(line.project.as_deref().unwrap_or_default())?;
        let image = self.image(instance)?;
        let name = line.program.as_deref().unwrap_or_default();
        let (number, program) = find_program(&image, name)
            .ok_or_else(|| refused(ExceptionCode::ProgramNotFound, "the application has no such program"))?;
        let no_line = || refused(ExceptionCode::ProgramLineNotFound, "the program has no such line");
        let file = image.files.get(program.file as usize).ok_or_else(no_line)?.clone();
        let near = program.lines.iter().chain(&program.closings).map(|line| line.row).next().ok_or_else(no_line)?;
        let counted = u32::try_from(line.number).map_err(|_| no_line())?;
        let row = self.evaluator.code_row(&file, near, counted).ok_or_else(no_line)?;
        let code = self.evaluator.code_line(&file, row).ok_or_else(no_line)?.text;
        match line.content.as_deref().map(str::trim).filter(|content| !content.is_empty()) {
            Some(content) if content != code.trim() => {
                Err(refused(ExceptionCode::MismatchedCode, "the line in memory has other code"))
            }
            _ => Ok((ProgramId { instance, number }, FileLine { file, row })),
        }
    }

    /// Instance of a project in memory.
    ///
    /// # Errors
    /// The project is not in memory.
    pub(crate) fn instance(&self, project: &str) -> Result<InstanceId, SoapFault> {
        let mut loaded = applications::loaded(&self.debugger.controller);
        let instance = loaded.find(|(_, name)| name.eq_ignore_ascii_case(project)).map(|(id, _)| id);
        instance.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "the application is not in memory"))
    }

    /// Like [`instance`](Self::instance), also with the bare name of the project.
    ///
    /// # Errors
    /// The project is not in memory.
    pub(crate) fn named_instance(&self, project: &str) -> Result<InstanceId, SoapFault> {
        let mut loaded = applications::loaded(&self.debugger.controller);
        let instance = loaded.find(|(_, name)| is_project_name(name, project)).map(|(id, _)| id);
        instance.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "the application is not in memory"))
    }

    fn image(&self, instance: InstanceId) -> Result<Arc<Image>, SoapFault> {
        let instance = self.debugger.controller.vm.space.instance(instance);
        let image = instance.map(|instance| Arc::clone(&instance.image));
        image.ok_or_else(|| refused(ExceptionCode::ApplicationNotFound, "the application is not in memory"))
    }
}

fn find_program<'i>(image: &'i Image, name: &str) -> Option<(u16, &'i Program)> {
    (0..).zip(&image.programs).find(|(_, program)| program.name.eq_ignore_ascii_case(name))
}
